#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// The scene on this ground (put_on_ground) in place of the one that it stands on, in the same
/// light; the same scene where it stands on it, or has no extent. Its lines and points are to be
/// drawn anew (with_strokes). Errors: more triangles than a scene may have, lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_ground(
    std::shared_ptr<const RenderScene> scene, Ground ground);

}  // namespace asos
