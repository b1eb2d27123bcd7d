#pragma once

#include "renderer/geometry/pixel_rect.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/background.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

// Parsers for values on the command line and in the library. They are locale-independent and must
// consume the whole text. Errors for values out of range state the range. The error's subject is
// the text itself.

namespace asos {

struct PictureSize {
  int width = 0;
  int height = 0;
};

struct LookAt {
  glm::dvec3 eye{0.0};
  glm::dvec3 target{0.0};
};

/// A finite number from lo to hi; with `open`, strictly between them.
[[nodiscard]] Result<double> parse_number(std::string_view text, double lo, double hi,
                                          bool open = false);
/// A whole number from lo to hi.
[[nodiscard]] Result<int> parse_whole(std::string_view text, int lo, int hi);
/// "WxH", both from 1 to `limit`.
[[nodiscard]] Result<PictureSize> parse_size(std::string_view text, int limit);
/// "x,y,w,h": a rectangle with w and h of at least 1.
[[nodiscard]] Result<PixelRect> parse_rect(std::string_view text, int limit);
/// "x,y": a pixel, both 0 or more.
[[nodiscard]] Result<glm::ivec2> parse_pixel(std::string_view text);
/// "ex,ey,ez,tx,ty,tz": two points that differ.
[[nodiscard]] Result<LookAt> parse_look_at(std::string_view text);
/// "MIN,MAX,N": one curve for all colours; MIN and MAX from 0 to 1, N from 0 to 1e6.
[[nodiscard]] Result<Dfr> parse_dfr(std::string_view text);
/// "R,G,B" or "R,G,B:R,G,B", linear, 0 to 1e6; a single colour is both. `otherwise`: the error's
/// reason for other texts.
[[nodiscard]] Result<std::pair<glm::vec3, glm::vec3>> parse_colours(std::string_view text,
                                                                    const char* otherwise);
/// Stops, -32 to 32; none: "auto".
[[nodiscard]] Result<std::optional<float>> parse_exposure(std::string_view text);
/// "environment", "blurred", "transparent", "R,G,B" or "R,G,B:R,G,B" (from the picture's upper to
/// its lower border; linear, 0 to 1e6).
[[nodiscard]] Result<Background> parse_background(std::string_view text);

/// One of the names in a table such as leaf_names.
template <typename Named, std::size_t N>
[[nodiscard]] auto parse_name(std::string_view text, std::span<const Named, N> known)
    -> Result<decltype(Named::value)> {
  std::string names;
  for (const Named& one : known) {
    if (text == one.name) return one.value;
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  return unexpected(Error{"\"" + std::string(text) + "\"", "not one of " + names});
}

}  // namespace asos
