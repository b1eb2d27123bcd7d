#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <vector>

namespace asos::stability {

/// Measures light as a photographer would: a matte floor in the plane y = 0, of which the picture's
/// only pixel shows a speck around the origin from above, is rendered in the dark under the lights
/// and under one lux, which give the illuminance at the origin.
struct LightMeter {
  std::vector<Light> lights;
  std::vector<Face> blockers;
  double floor_half = 1.0;  ///< half the floor's side
  int max_level = 3;
  RenderSettings (*change)(RenderSettings) = nullptr;  ///< applied to settings_of's result

  /// The case's figure: lux at the origin. The measure's bound is a share of `lux`, and comes on
  /// top of what float32 costs the two pictures.
  [[nodiscard]] Result<Outcome> measure(const Measure& measure, double lux) const;
};

}  // namespace asos::stability
