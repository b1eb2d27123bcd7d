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
  float f0 = 0.0f;        ///< largest of the colours
  float roughness = 0.0f;
  LobeStretch stretch = {};
  glm::vec2 stretch_turn{0.0f};  ///< tangent_turn of the patch
  float white = 1.0f;            ///< radiance of it that makes the pixel white, which shows no more
};

/// Whether normals and directions to the viewer turn so far across the patch that its reflectance
/// may be uneven.
[[nodiscard]] bool turns(const GlossyPatch& glossy);

/// By how much the share of light from all around that a patch mirrors (environment_specular) may
/// differ on average from that at its middle: Fresnel's term rises steeply towards grazing angles,
/// which a wide pyray holds many of. Simpson's rule beside the midpoint's.
[[nodiscard]] float reflectance_error(const GlossyPatch& glossy);

/// What a patch shows of a light in its highlight.
struct HighlightError {
  float error = 0.0f;     ///< of its mean display intensity (0 to 1), beside that at its middle
  float contrast = 0.0f;  ///< by how much samples of it differ, about; 1 is white
};

/// A bound for what ReflectedLights makes of the patch's highlight of a light with a size, by the
/// physical rule: of the mean (PatchBend), or where the patch is too wide for that of the middle.
[[nodiscard]] HighlightError highlight_error(const PreparedLight& light, const GlossyPatch& glossy);

}  // namespace asos
