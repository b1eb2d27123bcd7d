#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Returns whether the point of a light at the peak of its highlight is visible. Sends one ray,
/// which is counted for the light. `to_viewer` is unit.
[[nodiscard]] bool shows_highlight(const EyeContext& eye, std::uint32_t light,
                                   const SurfacePoint& point, glm::vec3 to_viewer);

/// Number of rays that reach a light, of thirteen: one to the highlight's peak, and four to each of
/// three circles around it. The circles contain a fifth, a half and four fifths of the lobe of a
/// surface with the given roughness.
struct HighlightRays {
  int sent = 0;
  int arrived = 0;
};
[[nodiscard]] HighlightRays rays_to_highlight(const EyeContext& eye, std::uint32_t light,
                                              const SurfacePoint& point, glm::vec3 to_viewer,
                                              float roughness);

}  // namespace asos
