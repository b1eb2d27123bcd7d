#include "renderer/world/placed_mesh.h"

#include <algorithm>

namespace asos {
namespace {

PlacedMesh place_flat(const Mesh& mesh) {
  PlacedMesh placed{&mesh, true, {}, {}};
  placed.source.reserve(mesh.triangles.size() * 3);
  placed.own_triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3 t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(placed.source.size());
    placed.source.insert(placed.source.end(), {t.x, t.y, t.z});
    placed.own_triangles.emplace_back(first, first + 1, first + 2);
  }
  return placed;
}

}  // namespace

PlacedMesh place(const Mesh& mesh) {
  if (mesh.normals.empty()) return place_flat(mesh);
  PlacedMesh placed{&mesh, false, {}, {}};
  constexpr std::uint32_t unused = 0xffffffffu;
  std::vector<std::uint32_t> to_placed(mesh.positions.size(), unused);
  for (const glm::uvec3 t : mesh.triangles) to_placed[t.x] = to_placed[t.y] = to_placed[t.z] = 0;
  if (std::find(to_placed.begin(), to_placed.end(), unused) == to_placed.end()) return placed;
  for (std::size_t i = 0; i < to_placed.size(); ++i) {
    if (to_placed[i] == unused) continue;
    to_placed[i] = static_cast<std::uint32_t>(placed.source.size());
    placed.source.push_back(static_cast<std::uint32_t>(i));
  }
  placed.own_triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3 t : mesh.triangles) {
    placed.own_triangles.emplace_back(to_placed[t.x], to_placed[t.y], to_placed[t.z]);
  }
  return placed;
}

bool is_coloured(const Mesh& mesh) {
  return std::any_of(mesh.colors.begin(), mesh.colors.end(),
                     [](glm::vec4 c) { return c != glm::vec4(1.0f); });
}

Attributes find_attributes(const Scene& scene, const std::vector<bool>& shown) {
  Attributes keep;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!shown[i]) continue;
    const Mesh& mesh = scene.meshes[i];
    keep.colors |= is_coloured(mesh);
    if (mesh.material < 0) continue;
    const Material& m = scene.materials[static_cast<std::size_t>(mesh.material)];
    const auto use = [&](const TextureUse& t) {
      if (t.used()) keep.texcoords[t.texcoord] = true;
    };
    use(m.base_color_texture);
    if (m.unlit) continue;
    for (const TextureUse* texture : texture_uses(m)) use(*texture);
    keep.tangents |= needs_tangents(m);
  }
  return keep;
}

}  // namespace asos
