#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/shading/sky.h"

#include <memory>
#include <vector>

namespace asos {

/// The lights that shine on the scene as it was prepared when this sky surrounds it (null: the
/// neutral one). Those that the scene has of its own stay whatever the sky is. In place of a rig an
/// environment has its sun, which is a disk at infinity, or nothing; or the rig follows its turn
/// and brightness.
[[nodiscard]] std::vector<Light> lights_under(const RenderScene& scene, const Sky* sky);

/// Whether they are others than those that the scene was prepared with.
[[nodiscard]] bool changes_lights(const RenderScene& scene, const Sky* sky);

/// The scene lit by them; itself where these are the lights that it was prepared with.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> lit_under(
    std::shared_ptr<const RenderScene> scene, const Sky* sky);

}  // namespace asos
