#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <vector>

namespace asos::stability {

/// Measures light as a photographer would: a matte floor in the plane y = 0, of which the picture's
/// only pixel shows a speck around the origin from above, is rendered under the lights, in the dark
/// and under one lux; the three give the illuminance at the origin.
struct LightMeter {
  std::vector<Light> lights;
  std::vector<Face> blockers;
  double floor_half = 1.0;  ///< half the floor's side
  int max_level = 3;
  RenderSettings (*change)(RenderSettings) = nullptr;  ///< applied to settings_of's result

  /// The case's figure: lux at the origin. The measure's bound is as a share of `lux` (of one lux
  /// where that is more), and comes on top of what float32 costs the three pictures.
  [[nodiscard]] Result<Outcome> measure(const Measure& measure, double lux) const;
};

}  // namespace asos::stability
