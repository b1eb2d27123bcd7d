#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// Returns the scene on this ground (put_on_ground) instead of its present one, with the same
/// lighting. Returns the same scene if it has this ground already, or has no extent. Its lines and
/// points have to be drawn again (with_lines). `as`: another moment of the scene, whose ground this
/// one gets, so that it stands still. Errors: more triangles than a scene may have, lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_ground(
    std::shared_ptr<const RenderScene> scene, Ground ground, const World* as = nullptr);

}  // namespace asos
