#include "renderer/gltf/declared_size.h"

#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/finite.h"
#include "renderer/gltf/instancing.h"
#include "renderer/gltf/lights_cameras.h"
#include "renderer/gltf/primitive.h"
#include "renderer/gltf/skin.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace asos::gltf {
namespace {

// A node with more copies adds only some of them to the box.
constexpr std::size_t most_copies = 10'000;
constexpr std::size_t most_instances_read = 4'000'000;

/// A box in double precision; empty if nothing was added.
struct DeclaredBox {
  glm::dvec3 lo{std::numeric_limits<double>::infinity()};
  glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool empty() const { return !(lo.x <= hi.x); }
  void grow(const DeclaredBox& box, const glm::dmat4& matrix) {
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec4 p((corner & 1) ? box.hi.x : box.lo.x, (corner & 2) ? box.hi.y : box.lo.y,
                         (corner & 4) ? box.hi.z : box.lo.z, 1.0);
      lo = glm::min(lo, glm::dvec3(matrix * p));
      hi = glm::max(hi, glm::dvec3(matrix * p));
    }
  }
};

/// Returns the largest value of a normalised component type, by which declared bounds are divided.
double largest_of(const tinygltf::Accessor& accessor) {
  if (!accessor.normalized) return 1.0;
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535.0;
    default:
      return 1.0;
  }
}

const tinygltf::Accessor* accessor_of(const tinygltf::Model& model,
                                      const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  const bool exists = found != primitive.attributes.end() && found->second >= 0 &&
                      static_cast<std::size_t>(found->second) < model.accessors.size();
  return exists ? &model.accessors[static_cast<std::size_t>(found->second)] : nullptr;
}

std::uint64_t elements_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const tinygltf::Accessor* accessor = accessor_of(model, primitive, Document::indices_attribute);
  if (!accessor) accessor = accessor_of(model, primitive, "POSITION");
  return accessor ? drawn_count(primitive.mode, accessor->count) : 0;
}

DeclaredBox box_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  const tinygltf::Accessor* const found = accessor_of(model, primitive, "POSITION");
  if (!found) return {};
  const tinygltf::Accessor& accessor = *found;
  if (accessor.minValues.size() != 3 || accessor.maxValues.size() != 3) return {};
  DeclaredBox box;
  for (int k = 0; k < 3; ++k) {
    box.lo[k] = accessor.minValues[static_cast<std::size_t>(k)] / largest_of(accessor);
    box.hi[k] = accessor.maxValues[static_cast<std::size_t>(k)] / largest_of(accessor);
  }
  const bool sound =
      finite(box.lo) && finite(box.hi) && glm::all(glm::lessThanEqual(box.lo, box.hi));
  return sound ? box : DeclaredBox{};
}

class SizeOfNodes {
 public:
  SizeOfNodes(Document& document, Accessors& accessors, const std::vector<NodePose>& poses)
      : doc_(document), accessors_(accessors), graph_(document, poses) {}

  std::optional<ScenePreview> run(int scene) {
    Scene cameras;
    for (const auto& [index, shown] : graph_.listed(scene)) {
      if (!shown) continue;
      const tinygltf::Node& node = doc_.model.nodes[static_cast<std::size_t>(index)];
      if (cameras.cameras.empty()) add_camera(doc_, node, graph_.world_from_node(index), cameras);
      add(index, node);
    }
    const double extent = glm::length(all_.hi - all_.lo);
    if (all_.empty() || !finite(all_.lo) || !finite(all_.hi) ||
        !(extent > 0.0 && extent <= largest_coordinate))
      return std::nullopt;
    ScenePreview preview{all_.lo, all_.hi, std::nullopt, triangles_};
    if (!cameras.cameras.empty()) preview.camera = cameras.cameras.front();
    return preview;
  }

 private:
  void add(int index, const tinygltf::Node& node) {
    if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= doc_.model.meshes.size()) return;
    DeclaredBox box;
    std::uint64_t elements = 0;
    for (const tinygltf::Primitive& primitive :
         doc_.model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      elements += elements_of(doc_.model, primitive);
      if (const DeclaredBox own = box_of(doc_.model, primitive); !own.empty())
        box.grow(own, glm::dmat4(1.0));
    }
    if (box.empty()) return;
    const glm::dmat4 placed = matrix_of(index, node);
    const auto copies =
        instance_matrices(node, "node", most_instances_read, accessors_, doc_.warnings);
    if (!copies) return;
    triangles_ += elements * copies->size();
    const std::size_t step = copies->size() / most_copies + 1;
    for (std::size_t i = 0; i < copies->size(); i += step) all_.grow(box, placed * (*copies)[i]);
  }

  [[nodiscard]] glm::dmat4 matrix_of(int index, const tinygltf::Node& node) {
    if (node.skin < 0) return graph_.world_from_node(index);
    const Checked<SkinPose> pose = skin_pose(doc_, accessors_, graph_, node.skin);
    return pose && !pose->joints.empty() ? pose->joints.front() : graph_.world_from_node(index);
  }

  Document& doc_;
  Accessors& accessors_;
  NodeGraph graph_;
  DeclaredBox all_;
  std::uint64_t triangles_ = 0;
};

}  // namespace

std::optional<ScenePreview> declared_size(Document& document, Accessors& accessors,
                                          const std::vector<NodePose>& poses, int scene) {
  const Warnings said = document.warnings;
  std::optional<ScenePreview> preview = SizeOfNodes(document, accessors, poses).run(scene);
  document.warnings = said;
  accessors.forget_zeros();
  return preview;
}

}  // namespace asos::gltf
