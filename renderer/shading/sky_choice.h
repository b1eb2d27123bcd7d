#pragma once

#include "renderer/result.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace asos {

class Sky;

/// Surroundings that are part of the program; see environments.h.
enum class Environment { softboxes, windows, studio, daylight, dusk, white, grey };

/// The user's choice of a scene's surroundings: the neutral grey, two colours, a file or an
/// environment.
struct SkyChoice {
  struct Colours {
    glm::vec3 zenith{0.0f};  ///< linear
    glm::vec3 horizon{0.0f};
    bool operator==(const Colours&) const = default;
  };
  std::optional<Colours> colours;
  std::string file;  ///< empty: none
  /// Turn of a file or an environment about +Y, counter-clockwise seen from above.
  double turn_deg = 0.0;
  /// Factor of the radiance of a file or an environment, 0 to most_brightness.
  double brightness = 1.0;
  static constexpr double most_brightness = 1000.0;
  std::optional<Environment> environment = std::nullopt;

  bool operator==(const SkyChoice&) const = default;
};

/// Reads "neutral", an environment's name, "R,G,B", "R,G,B:R,G,B" (zenith and horizon; linear, 0 to
/// 1e6) or the name of a file that ends in .hdr or .exr, which is not opened.
[[nodiscard]] Result<SkyChoice> parse_sky(std::string_view text);

/// Makes the chosen sky, null for the neutral one. Reads the file if there is one; errors name it.
[[nodiscard]] Result<std::shared_ptr<const Sky>> make_sky(const SkyChoice& choice);
/// Returns the choice from which a sky was made; for null, the neutral one.
[[nodiscard]] SkyChoice choice_of(const Sky* sky);

}  // namespace asos
