#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// A patch of a glossy surface around a point, with its viewer.
struct GlossyPatch {
  const SurfacePoint& point;
  NormalSpread turn;  ///< of the shading normal along the patch's edges
  Patch patch;
  glm::vec3 to_viewer;    ///< unit
  float viewer_distance;  ///< infinite for parallel rays
  Lobe lobe = {};
  glm::vec2 stretch_turn{0.0f};  ///< tangent_turn of the patch
  float white = 1.0f;            ///< radiance of the patch at which the pixel is white and clamped
};

/// Returns whether normals and view directions vary enough across the patch to vary its
/// reflectance.
[[nodiscard]] bool turns(const GlossyPatch& glossy);

/// Returns the average error of a patch's reflectance of uniform light (environment_specular) if
/// the centre's value is used. Fresnel's term rises steeply at grazing angles, and a wide pyray
/// covers many angles. Compares Simpson's rule with the midpoint rule.
[[nodiscard]] float reflectance_error(const GlossyPatch& glossy);

/// Error and contrast of a light's highlight on a patch.
struct HighlightError {
  float error = 0.0f;     ///< bound for the shaded radiance, clamped at `white`
  float contrast = 0.0f;  ///< approximate contrast of its samples; 1 is white
};

/// Returns a bound for the error of the patch's highlight of a light with an extent in
/// ReflectedLights, by the physical rule. It is the error of the mean (PatchCurvature), or that of
/// the centre where the patch is too wide.
[[nodiscard]] HighlightError highlight_error(const PreparedLight& light, const GlossyPatch& glossy);

}  // namespace asos
