#pragma once

#include <glm/glm.hpp>

namespace asos {

/// What the eye sees where no surface is. Mirrors, volumes of glass and lights see the environment
/// (RenderSettings::sky), whatever it is.
enum class BackgroundKind {
  environment,
  blurred,     ///< the environment's mean around each direction
  colours,     ///< a gradient down the picture, or one colour
  transparent  ///< nothing: pixels tell how much of them surfaces cover
};

/// What pixels hold. All but `light` are for passes of their own, without any light.
enum class PixelContent {
  light,
  coverage,      ///< the share that surfaces cover: see render_block
  unlit_share,   ///< the share that unlit surfaces cover, as the eye sees them: see add_unlit
  unlit_colour,  ///< the colour of these times their share
};

struct Background {
  static constexpr float brightest = 1e6f;

  BackgroundKind kind = BackgroundKind::environment;
  /// Of colours: linear radiance at the picture's upper and lower border, 0 to `brightest`.
  glm::vec3 top{0.35f};
  glm::vec3 bottom{0.35f};
  PixelContent content = PixelContent::light;

  bool operator==(const Background&) const = default;
};

}  // namespace asos
