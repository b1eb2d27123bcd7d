#pragma once

#include <glm/glm.hpp>

namespace asos {

/// The background that eye rays see beyond all surfaces. Reflections, glass volumes and lighting
/// always use the environment (RenderSettings::sky).
enum class BackgroundKind {
  environment,
  blurred,     ///< the environment, averaged around each direction
  colours,     ///< a vertical gradient, or one colour
  transparent  ///< none: pixels have coverage
};

/// The content of pixels. All but `light` are for separate passes without lighting.
enum class PixelContent {
  light,
  coverage,      ///< fraction covered by surfaces: see render_block
  unlit_share,   ///< fraction covered by directly visible unlit surfaces: see add_unlit
  unlit_colour,  ///< colour of these surfaces times their fraction
};

struct Background {
  static constexpr float brightest = 1e6f;

  BackgroundKind kind = BackgroundKind::environment;
  /// For `colours`: linear radiance at the picture's top and bottom, 0 to `brightest`.
  glm::vec3 top{0.35f};
  glm::vec3 bottom{0.35f};
  PixelContent content = PixelContent::light;

  bool operator==(const Background&) const = default;
};

}  // namespace asos
