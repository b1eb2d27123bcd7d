#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/scene/environment_cube.h"

#include <memory>

namespace asos::gltf {

/// Returns the environment light of a scene of the document (EXT_lights_image_based), from the
/// largest pictures of its cube; null for none. A broken light is left out completely, with a
/// warning that has its index and the reason.
[[nodiscard]] std::shared_ptr<const EnvironmentCube> image_based_light(Document& document,
                                                                       Accessors& accessors,
                                                                       int scene);

}  // namespace asos::gltf
