#pragma once

#include "renderer/world/world.h"

namespace asos {

/// Returns a texture's image; null if it is missing or empty.
[[nodiscard]] const Image* image_of(const World& world, int texture);

}  // namespace asos
