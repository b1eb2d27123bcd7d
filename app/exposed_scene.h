#pragma once

#include "app/opened_scene.h"

#include <memory>

namespace asos {

/// The scene of a picture while the shutter is open around its time; as it is where the method
/// shows one moment. `picture`: as OpenedScene::at's.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> exposed_scene(
    const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
    const RenderSettings& settings, const PictureDescription& picture, const OpenedScene& opened);

}  // namespace asos
