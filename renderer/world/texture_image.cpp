#include "renderer/world/texture_image.h"

#include <cstddef>

namespace asos {

const Image* image_of(const World& world, int texture) {
  if (texture < 0 || static_cast<std::size_t>(texture) >= world.textures.size()) return nullptr;
  const int index = world.textures[static_cast<std::size_t>(texture)].image;
  if (index < 0 || static_cast<std::size_t>(index) >= world.images.size()) return nullptr;
  const Image& image = world.images[static_cast<std::size_t>(index)];
  return image.width <= 0 || image.height <= 0 || image.rgba.empty() ? nullptr : &image;
}

}  // namespace asos
