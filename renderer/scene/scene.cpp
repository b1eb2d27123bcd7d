#include "renderer/scene/scene.h"

namespace asos {

std::uint64_t Scene::instanced_triangles() const {
  std::uint64_t count = 0;
  for (const Instance& instance : instances) {
    if (instance.mesh < 0 || static_cast<std::size_t>(instance.mesh) >= meshes.size()) continue;
    count += meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
  }
  return count;
}

}  // namespace asos
