#include "renderer/world/shared_meshes.h"

#include "renderer/world/render_features.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <map>
#include <utility>

namespace asos {
namespace {

// A place takes as much memory as some triangles.
constexpr std::size_t fewest_triangles = 32;
constexpr double most_anisotropy = 32.0;
// Rays are traced in the mesh's own space, in single precision.
constexpr float smallest_extent = 1.0f / 1024.0f;
constexpr float largest_extent = 1e6f;
constexpr double farthest_in_extents = 1024.0;

bool has_plain_material(const Scene& scene, const Mesh& mesh) {
  if (mesh.material < 0) return true;
  const Material& m = scene.materials[static_cast<std::size_t>(mesh.material)];
  const bool shines = m.emissive != glm::vec3(0.0f) && m.emissive_strength > 0.0f;
  return surface_kind(m) == SurfaceKind::opaque && !shines;
}

/// Returns whether a mesh's size and distance from its own origin suit single precision.
bool has_moderate_size(const Mesh& mesh) {
  Box box;
  for (const glm::uvec3 t : mesh.triangles)
    for (int k = 0; k < 3; ++k) box.grow(mesh.positions[t[k]]);
  const glm::vec3 size = box.hi - box.lo;
  const float extent = std::max({size.x, size.y, size.z});
  const glm::vec3 far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  return extent >= smallest_extent && extent <= largest_extent &&
         static_cast<double>(std::max({far.x, far.y, far.z})) <=
             farthest_in_extents * static_cast<double>(extent);
}

bool sharable(const Scene& scene, const Mesh& mesh) {
  return mesh.triangles.size() >= fewest_triangles && has_plain_material(scene, mesh) &&
         has_moderate_size(mesh);
}

bool sharable(const Instance& instance) {
  return instance.mesh >= 0 && instance.shape < 0 && !instance.shows_light &&
         distortion_of(glm::dmat3(instance.world_from_mesh)).anisotropy <= most_anisotropy;
}

/// Returns one flag per instance; `chosen` says of a mesh and the number of its instances whether
/// it is stored once.
template <typename Chosen>
std::vector<std::uint8_t> choose_instances(const Scene& scene, Chosen chosen) {
  if (scene.instanced_segments() + scene.instanced_points() > 0) return {};
  std::map<int, std::uint64_t> instances;
  for (const Instance& instance : scene.instances) {
    if (instance.shape >= 0) return {};
    if (sharable(instance)) ++instances[instance.mesh];
  }
  std::erase_if(instances, [&](const auto& counted) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(counted.first)];
    return !chosen(counted.first, counted.second) || !sharable(scene, mesh);
  });
  if (instances.empty()) return {};
  std::vector<std::uint8_t> shared;
  for (const Instance& instance : scene.instances)
    shared.push_back(sharable(instance) && instances.contains(instance.mesh));
  return shared;
}

bool same_mesh(const Mesh& a, const Mesh& b) {
  return a.material == b.material && a.triangles == b.triangles && a.positions == b.positions &&
         a.normals == b.normals && a.tangents == b.tangents && a.texcoords[0] == b.texcoords[0] &&
         a.texcoords[1] == b.texcoords[1] && a.colors == b.colors;
}

}  // namespace

MeshStore::MeshStore(const Scene& pose)
    : meshes_(pose.meshes), materials_(pose.materials), kept_(pose.meshes.size(), 1) {}

bool MeshStore::empty() const {
  return std::find(kept_.begin(), kept_.end(), 1) == kept_.end();
}

void MeshStore::compare(const Scene& pose) {
  const bool same_lists =
      pose.meshes.size() == meshes_.size() && pose.materials.size() == materials_.size();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (!kept_[i]) continue;
    const int material = meshes_[i].material;
    const auto number = static_cast<std::size_t>(material);
    kept_[i] = same_lists && same_mesh(meshes_[i], pose.meshes[i]) &&
               (material < 0 || pose.materials[number] == materials_[number]);
    dropped_ |= !kept_[i];
  }
  if (pose.meshes.size() > kept_.size()) kept_.resize(pose.meshes.size(), 0);
}

std::shared_ptr<const World> MeshStore::world_of(const Scene& scene, int mesh) {
  std::shared_ptr<const World>& world = worlds_[mesh];
  if (!world) world = shared_mesh(scene, mesh);
  return world;
}

std::vector<std::uint8_t> shared_instances(const Scene& scene, std::uint64_t fewest_copied) {
  if (fewest_copied == never_shared) return {};
  return choose_instances(scene, [&](int mesh, std::uint64_t count) {
    const auto triangles = scene.meshes[static_cast<std::size_t>(mesh)].triangles.size();
    return count >= 2 && count * triangles >= fewest_copied;
  });
}

std::vector<std::uint8_t> shared_instances(const Scene& scene, const MeshStore& meshes) {
  return choose_instances(scene, [&](int mesh, std::uint64_t) { return meshes.keeps(mesh); });
}

std::shared_ptr<const World> shared_mesh(const Scene& scene, int mesh) {
  Scene alone;
  alone.meshes.push_back(scene.meshes[static_cast<std::size_t>(mesh)]);
  Mesh& own = alone.meshes.back();
  if (own.material >= 0) {
    const Material& m = scene.materials[static_cast<std::size_t>(own.material)];
    alone.materials.push_back(m);
    own.material = 0;
    const auto uses = texture_uses(m);
    if (std::any_of(uses.begin(), uses.end(), [](const TextureUse* use) { return use->used(); }))
      alone.textures = scene.textures, alone.images = scene.images;
  }
  Instance& instance = alone.instances.emplace_back();
  instance.name = own.name;
  instance.mesh = 0;
  // The mesh is valid, since it was valid in the scene.
  World world =
      std::move(flatten(alone, most_triangles, glm::dvec3(0.0), never_shared).value().world);
  world.flat = own.normals.empty();
  release_unused_images(world);
  return std::make_shared<const World>(std::move(world));
}

}  // namespace asos
