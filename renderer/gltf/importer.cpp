#include "renderer/gltf/importer.h"

#include "renderer/gltf/instancing.h"
#include "renderer/gltf/light_values.h"
#include "renderer/gltf/lights_cameras.h"
#include "renderer/gltf/memory_check.h"
#include "renderer/gltf/shapes.h"
#include "renderer/gltf/skin.h"
#include "renderer/load_progress.h"
#include "renderer/scene/tessellate.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace asos::gltf {

namespace {

constexpr std::size_t most_instances = 4'000'000;

}  // namespace

Checked<Scene> Importer::run(int scene, Scene base) {
  scene_ = std::move(base);
  for (const auto& [index, shown] : graph_.listed(scene)) {
    node_ = nodes_++;
    stop_point();
    if (!shown) continue;
    const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
    add_camera(doc_, node, graph_.world_from_node(index), scene_);
    add_light(doc_, node, graph_.world_from_node(index), scene_);
    if (auto done = add_mesh(index, node); !done) return fault(done.error());
  }
  check_unshown();
  if (auto drawn = check_drawn(); !drawn) return fault(drawn.error());
  return std::move(scene_);
}

/// Adds a node's mesh. Fails only if the whole scene is too large; broken parts are left out with a
/// warning.
Checked<void> Importer::add_mesh(int index, const tinygltf::Node& node) {
  if (const std::optional<Shape> shape = node_shape(doc_, node))
    return add_shape(index, node, *shape);
  if (node.mesh < 0) {
    if (node.skin >= 0) doc_.warnings.add(fmt::format("node {} has a skin but no mesh", index));
    return {};
  }
  if (static_cast<std::size_t>(node.mesh) >= doc_.model.meshes.size()) {
    doc_.warnings.add_loss(
        fmt::format("node {} has mesh {}, which does not exist", index, node.mesh));
    return {};
  }
  shown_.insert(static_cast<std::size_t>(node.mesh));
  const tinygltf::Mesh& mesh = doc_.model.meshes[static_cast<std::size_t>(node.mesh)];
  const SkinPose* skin = nullptr;
  if (node.skin >= 0) {
    auto known = skins_.find(node.skin);
    if (known == skins_.end())
      known = skins_.emplace(node.skin, skin_pose(doc_, accessors_, graph_, node.skin)).first;
    const Checked<SkinPose>& pose = known->second;
    if (!pose) doc_.warnings.add(fmt::format("node {}: {}; drawn unskinned", index, pose.error()));
    if (pose) skin = &*pose;
  }
  const auto copies = instance_matrices(node, fmt::format("node {}", index), most_instances,
                                        accessors_, doc_.warnings);
  if (!copies) return fault(copies.error());
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    stop_point();
    auto done = add_primitive(index, static_cast<int>(p), skin, *copies);
    if (!done) return done;
  }
  return {};
}

/// Adds a shape. The node's mesh represents the shape and is not drawn; without a mesh, one is
/// made.
Checked<void> Importer::add_shape(int index, const tinygltf::Node& node, const Shape& shape) {
  const glm::dmat4 world_from_shape = graph_.world_from_node(index);
  int mesh = -1;
  const auto listed = static_cast<std::size_t>(node.mesh);
  if (node.mesh >= 0 && listed < doc_.model.meshes.size() &&
      !doc_.model.meshes[listed].primitives.empty()) {
    shown_.insert(listed);
    glm::dmat4 unused(1.0);
    mesh = load(index, 0, nullptr, fmt::format("mesh {} primitive 0", node.mesh), unused);
  }
  if (mesh < 0) {
    mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(tessellated(shape));
  }
  const auto known = std::find(scene_.shapes.begin(), scene_.shapes.end(), shape);
  const auto number = static_cast<int>(known - scene_.shapes.begin());
  if (known == scene_.shapes.end()) scene_.shapes.push_back(shape);
  const bool shows_light = on_or_off(node.extras, "asos_light_fallback").value_or(false);
  const auto copies = instance_matrices(node, fmt::format("node {}", index), most_instances,
                                        accessors_, doc_.warnings);
  if (!copies) return fault(copies.error());
  for (const glm::dmat4& copy : *copies) {
    if (scene_.instances.size() >= most_instances)
      return fault(fmt::format("has more than {} objects, which is the limit", most_instances));
    scene_.instances.push_back(
        {node.name, mesh, world_from_shape * copy, shows_light, number, node_});
  }
  return {};
}

Checked<void> Importer::add_primitive(int index, int p, const SkinPose* skin,
                                      const std::vector<glm::dmat4>& copies) {
  const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
  const tinygltf::Mesh& mesh = doc_.model.meshes[static_cast<std::size_t>(node.mesh)];
  const tinygltf::Primitive& primitive = mesh.primitives[static_cast<std::size_t>(p)];
  const std::string place = fmt::format("mesh {} primitive {}", node.mesh, p);
  const Checked<std::uint64_t> elements = element_count(primitive, accessors_);
  if (!elements) {
    doc_.warnings.add_loss(fmt::format("{} is left out: {}", place, elements.error()));
    return {};
  }
  const std::uint64_t count = drawn_count(primitive.mode, *elements);
  if (!is_drawn(primitive.mode, place)) return {};
  // Check before anything of this size is allocated.
  triangles_ += count * copies.size();
  if (triangles_ > options_.max_triangles) {
    return fault(fmt::format("has more than {} triangles, lines and points, which is the limit",
                             options_.max_triangles));
  }
  const std::uint64_t objects = scene_.instances.size() + copies.size();
  if (objects > most_instances) {
    return fault(fmt::format("has more than {} objects, which is the limit", most_instances));
  }
  static const std::uint64_t present = memory_of_machine();
  if (auto fits = check_memory(triangles_, objects, present); !fits) return fits;
  glm::dmat4 world_from_mesh = graph_.world_from_node(index);
  const bool skinned = skin && primitive.attributes.contains("JOINTS_0");
  if (skin && !skinned) doc_.warnings.add(place + " has a skin, but no joints");
  if (skinned) world_from_mesh = glm::dmat4(1.0);
  const int loaded = load(index, p, skinned ? skin : nullptr, place, world_from_mesh);
  const bool shows_light = on_or_off(node.extras, "asos_light_fallback").value_or(false);
  // Reserve, since a growing list would be in memory twice.
  if (loaded >= 0 && copies.size() > scene_.instances.capacity() / 2)
    scene_.instances.reserve(scene_.instances.size() + copies.size());
  for (const glm::dmat4& copy : copies) {
    if (loaded < 0) continue;
    scene_.instances.push_back(
        {node.name, loaded, world_from_mesh * copy, shows_light, -1, node_, p});
  }
  return {};
}

bool Importer::is_drawn(int mode, const std::string& place) {
  if (mode >= TINYGLTF_MODE_POINTS && mode <= TINYGLTF_MODE_TRIANGLE_FAN) return true;
  doc_.warnings.add_loss(fmt::format("{} has the unknown mode {}; left out", place, mode));
  return false;
}

/// Returns the scene's mesh for a primitive, or -1 if it is left out. Adds a skin's offset to
/// `world_from_mesh`.
int Importer::load(int index, int p, const SkinPose* skin, const std::string& place,
                   glm::dmat4& world_from_mesh) {
  const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
  const tinygltf::Mesh& mesh = doc_.model.meshes[static_cast<std::size_t>(node.mesh)];
  const tinygltf::Primitive& primitive = mesh.primitives[static_cast<std::size_t>(p)];
  PrimitiveRequest request{primitive, place, {}, skin, graph_.world_from_node(index), nullptr};
  if (!primitive.targets.empty() || !mesh.weights.empty()) {
    const std::vector<double>& own = graph_.pose(index).weights;
    const std::vector<double>& all = own.empty() ? mesh.weights : own;
    const std::size_t targets = primitive.targets.size();
    if (all.size() > targets)
      doc_.warnings.add(
          fmt::format("{}: {} weights for {} morph targets", place, all.size(), targets));
    // Keep only as many weights as are needed, since they are part of the primitive's key.
    const auto used = static_cast<std::ptrdiff_t>(std::min(all.size(), targets));
    request.weights.assign(all.begin(), all.begin() + used);
  }
  const MeshKey key{node.mesh, p, request.weights};
  // A skin's mesh is posed, so no other node shares it.
  if (const auto known = meshes_.find(key); !skin && known != meshes_.end()) return known->second;
  const int material = material_of(primitive, place);
  if (material >= 0) request.material = &scene_.materials[static_cast<std::size_t>(material)];

  const auto number = static_cast<std::size_t>(index);
  const bool moves = still_.morphing_nodes.contains(number) ||
                     still_.moving_materials.contains(static_cast<std::size_t>(material));
  const bool still = still_.wanted && !skin && !moves;
  const auto made = still ? still_.meshes.find(key) : still_.meshes.end();
  std::optional<Mesh> loaded = made != still_.meshes.end()
                                   ? made->second
                                   : load_mesh(std::move(request), mesh.name, world_from_mesh);
  if (loaded) loaded->material = material;
  if (still && made == still_.meshes.end()) still_.meshes.emplace(key, loaded);
  const int number_in_scene = loaded ? static_cast<int>(scene_.meshes.size()) : -1;
  if (!skin) meshes_[key] = number_in_scene;
  if (loaded) scene_.meshes.push_back(std::move(*loaded));
  return number_in_scene;
}

// Adds a skin's offset to `world_from_mesh`.
std::optional<Mesh> Importer::load_mesh(PrimitiveRequest request, const std::string& name,
                                        glm::dmat4& world_from_mesh) {
  Checked<LoadedMesh> loaded = load_primitive(request, accessors_, doc_.warnings);
  if (!loaded) {
    doc_.warnings.add_loss(fmt::format("{} is left out: {}", request.place, loaded.error()));
    return std::nullopt;
  }
  if (loaded->mesh.triangles.empty() && !loaded->mesh.has_lines()) return std::nullopt;
  world_from_mesh[3] += glm::dvec4(loaded->offset, 0.0);
  loaded->mesh.name = name;
  return std::move(loaded->mesh);
}

int Importer::material_of(const tinygltf::Primitive& primitive, const std::string& place) {
  if (primitive.material < 0) return -1;
  if (static_cast<std::size_t>(primitive.material) < scene_.materials.size()) {
    return primitive.material;
  }
  doc_.warnings.add(fmt::format("{} has material {}, which does not exist; drawn plain", place,
                                primitive.material));
  return -1;
}

/// Checks meshes that no node uses. They are not loaded, but their faults are reported.
void Importer::check_unshown() {
  for (std::size_t m = 0; m < doc_.model.meshes.size(); ++m) {
    const std::vector<tinygltf::Primitive>& primitives = doc_.model.meshes[m].primitives;
    for (std::size_t p = 0; p < primitives.size() && !shown_.contains(m); ++p) {
      const std::string place = fmt::format("mesh {} primitive {} (not shown)", m, p);
      if (auto faults = declared_faults(primitives[p], accessors_); !faults.empty()) {
        doc_.warnings.add(place + ": " + faults);
      }
      (void)material_of(primitives[p], place);
    }
  }
}

Checked<void> Importer::check_drawn() {
  if (scene_.instanced_triangles() + scene_.instanced_segments() + scene_.instanced_points() > 0 ||
      !scene_.shapes.empty())
    return {};
  if (!doc_.warnings.first_loss().empty()) return fault(doc_.warnings.first_loss());
  doc_.warnings.add("nothing to draw: the scene has no triangles, lines or points");
  return {};
}

}  // namespace asos::gltf
