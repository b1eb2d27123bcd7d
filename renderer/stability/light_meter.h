#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <vector>

namespace asos::stability {

/// Measures light as a photographer would. A matte floor in the plane y = 0 is rendered from above
/// in a picture of one pixel around the origin. The picture under the lights relative to the
/// picture under one lux is the illuminance at the origin.
struct LightMeter {
  std::vector<Light> lights;
  std::vector<Face> blockers;
  double floor_half = 1.0;  ///< half the floor's side
  int max_level = 3;
  RenderSettings (*change)(RenderSettings) = nullptr;  ///< applied to settings_of's result

  /// Returns the case's result: lux at the origin. The measure's bound is relative to `lux`; the
  /// float32 error of the two pictures is added.
  [[nodiscard]] Result<Outcome> measure(const Measure& measure, double lux) const;
};

}  // namespace asos::stability
