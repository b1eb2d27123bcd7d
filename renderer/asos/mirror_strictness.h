#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/shading/surface.h"

namespace asos {

/// By how many times less a curved surface may spread a pyray that it mirrors than
/// MirrorSettings::widest_angle_deg says, at least 1: for a share of light above a quarter, since
/// what it shows is off by that share; and for a mesh, whose triangles tell of their own bend only,
/// and their neighbours are bent otherwise. `to_viewer` is unit.
[[nodiscard]] double mirror_strictness(const RenderScene& scene, const Hit& hit,
                                       const SurfacePoint& point, glm::vec3 to_viewer);

}  // namespace asos
