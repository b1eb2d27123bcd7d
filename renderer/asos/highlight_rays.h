#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Whether nothing lies before the place of a light that a highlight at the point shows most of: by
/// a ray, which is counted for the light. `to_viewer` is unit.
[[nodiscard]] bool shows_highlight(const EyeContext& eye, std::uint32_t light,
                                   const SurfacePoint& point, glm::vec3 to_viewer);

/// How many of thirteen rays reach the light: to that place, and to four on each of three circles
/// around it, within which a fifth, a half and four fifths lie of the lobe of a surface of that
/// roughness.
struct HighlightRays {
  int sent = 0;
  int arrived = 0;
};
[[nodiscard]] HighlightRays rays_to_highlight(const EyeContext& eye, std::uint32_t light,
                                              const SurfacePoint& point, glm::vec3 to_viewer,
                                              float roughness);

}  // namespace asos
