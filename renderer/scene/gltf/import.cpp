#include "renderer/scene/gltf/instancing.h"
#include "renderer/scene/gltf/light_values.h"
#include "renderer/scene/gltf/lights_cameras.h"
#include "renderer/scene/gltf/materials.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/gltf/primitive.h"
#include "renderer/scene/gltf/shapes.h"
#include "renderer/scene/gltf/skin.h"
#include "renderer/scene/load.h"
#include "renderer/scene/tessellate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace asos {

namespace gltf {
namespace {

constexpr std::size_t most_instances = 4'000'000;

/// Turns a document into a scene, node by node.
class Importer {
 public:
  Importer(Document& document, const LoadOptions& options)
      : doc_(document),
        options_(options),
        accessors_(document),
        textures_(document, accessors_, scene_),
        graph_(document, pose_at_start(document, accessors_)) {}

  Checked<Scene> run() {
    const Checked<int> chosen = choose_scene();
    if (!chosen) return fault(chosen.error());
    if (*chosen >= 0) scene_.name = doc_.model.scenes[static_cast<std::size_t>(*chosen)].name;
    import_materials(doc_, textures_, scene_);
    for (const int index : graph_.shown(*chosen)) {
      const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
      add_camera(doc_, node, graph_.world_from_node(index), scene_);
      add_light(doc_, node, graph_.world_from_node(index), scene_);
      if (auto done = add_mesh(index, node); !done) return fault(done.error());
    }
    return finish();
  }

 private:
  Checked<int> choose_scene() {
    const auto count = static_cast<int>(doc_.model.scenes.size());
    if (options_.scene_index >= count) {
      return fault(
          fmt::format("has {} scenes, so there is no scene {}", count, options_.scene_index));
    }
    if (options_.scene_index >= 0) return options_.scene_index;
    if (count == 0) {
      if (!doc_.model.nodes.empty()) doc_.warnings.add("has no scene; all its nodes are shown");
      return -1;
    }
    if (doc_.model.defaultScene >= count) {
      doc_.warnings.add(fmt::format("its default scene {} does not exist; scene 0 is shown",
                                    doc_.model.defaultScene));
    } else if (doc_.model.defaultScene >= 0) {
      return doc_.model.defaultScene;
    }
    return 0;
  }

  /// Fails only where the whole scene is too large; what is broken is left out with a warning.
  Checked<void> add_mesh(int index, const tinygltf::Node& node) {
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
    std::optional<SkinPose> skin;
    if (node.skin >= 0) {
      Checked<SkinPose> pose = skin_pose(doc_, accessors_, graph_, node.skin);
      if (!pose)
        doc_.warnings.add(fmt::format("node {}: {}; drawn unskinned", index, pose.error()));
      if (pose) skin = std::move(*pose);
    }
    const std::vector<glm::dmat4> copies =
        instance_matrices(node, fmt::format("node {}", index), accessors_, doc_.warnings);
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      auto done = add_primitive(index, static_cast<int>(p), skin ? &*skin : nullptr, copies);
      if (!done) return done;
    }
    return {};
  }

  /// The node's mesh stands for the shape, and is not drawn; one is made where there is none.
  Checked<void> add_shape(int index, const tinygltf::Node& node, const Shape& shape) {
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
    for (const glm::dmat4& copy :
         instance_matrices(node, fmt::format("node {}", index), accessors_, doc_.warnings)) {
      if (scene_.instances.size() >= most_instances)
        return fault(fmt::format("has more than {} objects, which is the limit", most_instances));
      scene_.instances.push_back({node.name, mesh, world_from_shape * copy, shows_light, number});
    }
    return {};
  }

  Checked<void> add_primitive(int index, int p, const SkinPose* skin,
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
    if (!is_drawn(primitive.mode, count * copies.size(), place)) return {};
    // Before anything of this size is allocated.
    triangles_ += count * copies.size();
    if (triangles_ > options_.max_triangles) {
      return fault(
          fmt::format("has more than {} triangles, which is the limit", options_.max_triangles));
    }
    if (scene_.instances.size() + copies.size() > most_instances) {
      return fault(fmt::format("has more than {} objects, which is the limit", most_instances));
    }
    glm::dmat4 world_from_mesh = graph_.world_from_node(index);
    const bool skinned = skin && primitive.attributes.contains("JOINTS_0");
    if (skin && !skinned) doc_.warnings.add(place + " has a skin, but no joints");
    if (skinned) world_from_mesh = glm::dmat4(1.0);
    const int loaded = load(index, p, skinned ? skin : nullptr, place, world_from_mesh);
    const bool shows_light = on_or_off(node.extras, "asos_light_fallback").value_or(false);
    for (const glm::dmat4& copy : copies) {
      if (loaded < 0) continue;
      scene_.instances.push_back({node.name, loaded, world_from_mesh * copy, shows_light, -1});
    }
    return {};
  }

  bool is_drawn(int mode, std::uint64_t count, const std::string& place) {
    if (mode >= TINYGLTF_MODE_TRIANGLES && mode <= TINYGLTF_MODE_TRIANGLE_FAN) return true;
    if (mode == TINYGLTF_MODE_POINTS) {
      scene_.notes.points_not_drawn += count;
    } else if (mode >= TINYGLTF_MODE_LINE && mode <= TINYGLTF_MODE_LINE_STRIP) {
      scene_.notes.lines_not_drawn += count;
    } else {
      doc_.warnings.add_loss(fmt::format("{} has the unknown mode {}; left out", place, mode));
    }
    return false;
  }

  /// The scene's mesh for a primitive, or -1 where it is left out. Adds a skin's offset to
  /// `world_from_mesh`.
  int load(int index, int p, const SkinPose* skin, const std::string& place,
           glm::dmat4& world_from_mesh) {
    const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
    const tinygltf::Mesh& mesh = doc_.model.meshes[static_cast<std::size_t>(node.mesh)];
    const tinygltf::Primitive& primitive = mesh.primitives[static_cast<std::size_t>(p)];
    PrimitiveRequest request{primitive, place, {}, skin, graph_.world_from_node(index), nullptr};
    if (!primitive.targets.empty() || !mesh.weights.empty()) {
      const std::vector<double>& own = graph_.pose(index).weights;
      request.weights = own.empty() ? mesh.weights : own;
    }
    const auto key = std::make_tuple(node.mesh, p, request.weights);
    if (const auto known = meshes_.find(key); !skin && known != meshes_.end()) {
      return known->second;
    }
    const int material = material_of(primitive, place);
    if (material >= 0) request.material = &scene_.materials[static_cast<std::size_t>(material)];
    Checked<LoadedMesh> loaded = load_primitive(request, accessors_, doc_.warnings);
    int& known = meshes_[key];
    known = -1;
    if (!loaded) {
      doc_.warnings.add_loss(fmt::format("{} is left out: {}", place, loaded.error()));
      return known;
    }
    if (loaded->mesh.triangles.empty()) return known;
    world_from_mesh[3] += glm::dvec4(loaded->offset, 0.0);
    loaded->mesh.name = mesh.name;
    loaded->mesh.material = material;
    known = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(loaded->mesh));
    return known;
  }

  int material_of(const tinygltf::Primitive& primitive, const std::string& place) {
    if (primitive.material < 0) return -1;
    if (static_cast<std::size_t>(primitive.material) < scene_.materials.size()) {
      return primitive.material;
    }
    doc_.warnings.add(fmt::format("{} has material {}, which does not exist; drawn plain", place,
                                  primitive.material));
    return -1;
  }

  /// Meshes that no node shows are not loaded, but what is wrong with them is worth a word.
  void check_unshown() {
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

  Checked<Scene> finish() {
    check_unshown();
    if (scene_.instanced_triangles() == 0 && scene_.shapes.empty()) {
      const bool other = scene_.notes.points_not_drawn + scene_.notes.lines_not_drawn > 0;
      if (!doc_.warnings.first_loss().empty()) return fault(doc_.warnings.first_loss());
      doc_.warnings.add(other ? "nothing to draw: points and lines are not drawn"
                              : "nothing to draw: the scene has no triangles");
    }
    scene_.notes.warnings_dropped = doc_.warnings.dropped();
    scene_.notes.warnings = doc_.warnings.take();
    scene_.notes.unsupported_extensions = doc_.unsupported_extensions;
    return std::move(scene_);
  }

  Document& doc_;
  const LoadOptions& options_;
  Scene scene_;
  Accessors accessors_;
  Textures textures_;
  NodeGraph graph_;
  std::map<std::tuple<int, int, std::vector<double>>, int> meshes_;
  std::set<std::size_t> shown_;  // meshes
  std::uint64_t triangles_ = 0;
};

}  // namespace
}  // namespace gltf

Result<Scene> import_gltf(const std::string& path, const LoadOptions& options) {
  // The libraries underneath report lack of memory and some broken data by exceptions.
  try {
    gltf::Checked<gltf::Document> document = gltf::read_document(path);
    if (!document) return unexpected(Error{path, document.error()});
    gltf::Checked<Scene> scene = gltf::Importer(*document, options).run();
    if (!scene) return unexpected(Error{path, scene.error()});
    scene->source = path;
    return std::move(*scene);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{path, "there is not enough memory for it"});
  } catch (const std::exception& e) {
    return unexpected(Error{path, fmt::format("cannot be read ({})", e.what())});
  }
}

}  // namespace asos
