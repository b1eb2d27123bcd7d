#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// A skin's matrices, world_from_joint * inverse bind, at the time that is shown.
struct SkinPose {
  std::vector<glm::dmat4> joints;
};

/// The primitive to make a mesh from, and how.
struct PrimitiveRequest {
  const tinygltf::Primitive& primitive;
  std::string place;                   ///< "mesh 3 primitive 0", for messages
  std::vector<double> weights;         ///< of the morph targets; may be shorter than them
  const SkinPose* skin = nullptr;      ///< null: not skinned
  glm::dmat4 world_from_node{1.0};     ///< for what a skin leaves unplaced
  const Material* material = nullptr;  ///< null: glTF's default
};

struct LoadedMesh {
  Mesh mesh;
  glm::dvec3 offset{0.0};  ///< skinned: world = position + offset
};

/// How many vertices of a primitive go into drawing it: its indices, or else its positions.
[[nodiscard]] Checked<std::uint64_t> element_count(const tinygltf::Primitive& primitive,
                                                   Accessors& accessors);
/// Triangles, points or segments of lines that `elements` make.
[[nodiscard]] std::uint64_t drawn_count(int mode, std::uint64_t elements);

/// The faults of a primitive's accessors, without reading their data; empty if nothing.
[[nodiscard]] std::string declared_faults(const tinygltf::Primitive& primitive,
                                          Accessors& accessors);

/// The triangles of one primitive: attributes read, morphed, skinned, and completed with normals
/// and tangents; or its lines or points, with positions and colours alone. What has vertices that
/// do not exist or are not finite is dropped with a warning. Faults: there are no usable positions
/// or indices.
[[nodiscard]] Checked<LoadedMesh> load_primitive(const PrimitiveRequest& request,
                                                 Accessors& accessors, Warnings& warnings);

}  // namespace asos::gltf
