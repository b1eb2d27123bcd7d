#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <memory>

namespace asos {

/// Returns whether with_images can put the images of `scene` into a prepared scene: the textures
/// are the same.
[[nodiscard]] bool has_images_for(const Scene& scene, const RenderScene& prepared);

/// Returns a prepared scene with the images of `scene`: the same file, whose images were left out
/// when it was prepared (LoadProgress::allow_missing_textures). Surfaces, hierarchies and edits are
/// shared. The default lights change if they were found by rays that holes let through, and then
/// own_lighting is another one. Errors: lack of memory.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_images(
    const std::shared_ptr<const RenderScene>& prepared, const Scene& scene);

}  // namespace asos
