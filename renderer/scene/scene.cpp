#include "renderer/scene/scene.h"

namespace asos {

std::uint64_t Scene::instanced_triangles() const {
  std::uint64_t count = 0;
  for (const Instance& instance : instances) {
    if (instance.mesh < 0 || static_cast<std::size_t>(instance.mesh) >= meshes.size()) continue;
    if (instance.shape >= 0 && static_cast<std::size_t>(instance.shape) < shapes.size()) {
      const bool box = shapes[static_cast<std::size_t>(instance.shape)].type == Shape::Type::box;
      count += box ? 12u : 0u;
      continue;
    }
    count += meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
  }
  return count;
}

}  // namespace asos
