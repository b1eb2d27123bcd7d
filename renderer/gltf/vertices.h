#pragma once

#include "renderer/gltf/compressed.h"
#include "renderer/gltf/primitive.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace asos::gltf {

/// Joint numbers and weights of every vertex, four at a time.
struct Influences {
  std::vector<glm::uvec4> joints;
  std::vector<glm::vec4> weights;
};

/// A primitive's attributes; empty where it has none, else as long as `positions`.
struct VertexData {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec2> texcoords[2];
  std::vector<glm::vec4> colors;
  std::vector<Influences> influences;
};

/// Where a primitive's attributes come from: accessors, or a Draco stream.
class AttributeSource {
 public:
  AttributeSource(const PrimitiveRequest& request, const DracoPrimitive* draco,
                  Accessors& accessors, Warnings& warnings)
      : request_(request), draco_(draco), accessors_(accessors), warnings_(warnings) {}

  /// Vertices that POSITION declares.
  [[nodiscard]] Checked<std::size_t> vertex_count() const;
  /// The selected vertices, morphed. Only positions are indispensable: another attribute that is
  /// broken is left out with a warning.
  [[nodiscard]] Checked<VertexData> read(const Selection& selection);

 private:
  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] Checked<std::vector<float>> floats(const std::string& name, int components,
                                                   const Selection& selection) const;
  [[nodiscard]] Checked<int> components(const std::string& name) const;
  /// `floats` of an attribute that may be missing; broken ones are warned of.
  [[nodiscard]] std::vector<float> optional(const std::string& name, int components,
                                            const Selection& selection);
  void read_colors(VertexData& data, const Selection& selection);
  void read_influences(VertexData& data, const Selection& selection);
  void morph(VertexData& data, const Selection& selection);

  const PrimitiveRequest& request_;
  const DracoPrimitive* draco_;
  Accessors& accessors_;
  Warnings& warnings_;
  std::size_t declared_ = 0;
};

}  // namespace asos::gltf
