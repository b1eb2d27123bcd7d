#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/scene/surroundings.h"

#include <memory>

namespace asos::gltf {

/// The light from all around that a scene of the document names (EXT_lights_image_based), by the
/// largest pictures of its cube; null for none. What is broken is left out as a whole, with a
/// warning that names the light and what is wrong.
[[nodiscard]] std::shared_ptr<const Surroundings> image_based_light(Document& document,
                                                                    Accessors& accessors,
                                                                    int scene);

}  // namespace asos::gltf
