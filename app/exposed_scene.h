#pragma once

#include "app/opened_scene.h"

#include <memory>

namespace asos {

/// The scene of a picture while the shutter is open around its time; unchanged if the method shows
/// one moment. `picture`: see OpenedScene::at.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> exposed_scene(
    const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
    const RenderSettings& settings, const PictureDescription& picture, const OpenedScene& opened);

}  // namespace asos
