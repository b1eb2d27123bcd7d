#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// A patch of a glossy surface around a point, as a viewer sees it.
struct GlossyPatch {
  const SurfacePoint& point;
  NormalSpread turn;  ///< of the shading normal along the patch's edges
  Patch patch;
  glm::vec3 to_viewer;    ///< unit
  float viewer_distance;  ///< infinite for parallel rays
  float f0;               ///< largest of the colours
  float roughness;
};

/// By how much the mean display intensity (0 to 1) of what a patch shows of a light in its
/// highlight may differ from that at its middle: Simpson's rule beside the midpoint's, of the
/// highlight's integral (LightQuadrature), where a bound is not below `negligible`; that bound
/// where the patch is wider than the highlight. For lights with a size, by the physical rule.
[[nodiscard]] float highlight_error(const PreparedLight& light, const GlossyPatch& glossy,
                                    float negligible);

}  // namespace asos
