#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/shading/sky.h"

#include <memory>
#include <vector>

namespace asos {

/// Returns the lights of the prepared scene under this sky (null: the neutral one). The scene's own
/// lights do not depend on the sky. Default lights are replaced by the environment's sun, which is
/// a disk at infinity, or by nothing; or they follow its turn and brightness.
[[nodiscard]] std::vector<Light> lights_under(const RenderScene& scene, const Sky* sky);

/// Returns whether lights_under differ from the prepared lights of the scene.
[[nodiscard]] bool changes_lights(const RenderScene& scene, const Sky* sky);

/// Returns the scene with the lights under the sky; the same scene if they do not differ.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> lit_under(
    std::shared_ptr<const RenderScene> scene, const Sky* sky);

}  // namespace asos
