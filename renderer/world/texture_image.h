#pragma once

#include "renderer/world/world.h"

namespace asos {

/// A texture's image; null where it is missing or empty.
[[nodiscard]] const Image* image_of(const World& world, int texture);

}  // namespace asos
