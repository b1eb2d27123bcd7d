#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// A skin's matrices, world_from_joint * inverse bind, at one time.
struct SkinPose {
  std::vector<glm::dmat4> joints;
};

/// The primitive from which to make a mesh, and its parameters.
struct PrimitiveRequest {
  const tinygltf::Primitive& primitive;
  std::string place;                   ///< "mesh 3 primitive 0", for messages
  std::vector<double> weights;         ///< of the morph targets; may be fewer
  const SkinPose* skin = nullptr;      ///< null: not skinned
  glm::dmat4 world_from_node{1.0};     ///< for vertices without weights in a skin
  const Material* material = nullptr;  ///< null: glTF's default
};

struct LoadedMesh {
  Mesh mesh;
  glm::dvec3 offset{0.0};  ///< skinned: world = position + offset
};

/// Returns the number of vertices for drawing a primitive: its indices, or else its positions.
[[nodiscard]] Checked<std::uint64_t> element_count(const tinygltf::Primitive& primitive,
                                                   Accessors& accessors);
/// Returns the number of triangles, points or line segments of this many elements.
[[nodiscard]] std::uint64_t drawn_count(int mode, std::uint64_t elements);

/// Returns the faults of a primitive's accessors, without reading their data; empty if none.
[[nodiscard]] std::string declared_faults(const tinygltf::Primitive& primitive,
                                          Accessors& accessors);

/// Loads one primitive. Its attributes are read, morphed and skinned. Triangles are completed with
/// normals and tangents; lines and points are not, and have no tangents. Elements with vertices
/// that do not exist or are not finite are dropped with a warning. Faults: there are no usable
/// positions or indices.
[[nodiscard]] Checked<LoadedMesh> load_primitive(const PrimitiveRequest& request,
                                                 Accessors& accessors, Warnings& warnings);

}  // namespace asos::gltf
