#include "renderer/scene/scene.h"

namespace asos {
namespace {

/// Returns the sum of `count` over the meshes of all instances that are not shapes.
template <typename Count>
std::uint64_t over_instances(const Scene& scene, Count count) {
  std::uint64_t sum = 0;
  for (const Instance& i : scene.instances) {
    if (i.shape >= 0 || i.mesh < 0 || static_cast<std::size_t>(i.mesh) >= scene.meshes.size())
      continue;
    sum += count(scene.meshes[static_cast<std::size_t>(i.mesh)]);
  }
  return sum;
}

}  // namespace

std::uint64_t Scene::instanced_segments() const {
  return over_instances(*this, [](const Mesh& mesh) { return mesh.segments.size(); });
}

std::uint64_t Scene::instanced_points() const {
  return over_instances(*this, [](const Mesh& mesh) { return mesh.points.size(); });
}

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
