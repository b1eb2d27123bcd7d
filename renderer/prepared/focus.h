#pragma once

#include "renderer/geometry/camera.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

namespace asos {

/// The camera with the focus of its lens: where that is automatic, at the depth of what the middle
/// of the picture shows, or nearest to it; of the scene's middle where the picture shows nothing.
[[nodiscard]] Camera focused(const RenderScene& scene, const Camera& camera,
                             const RenderSettings& settings);

}  // namespace asos
