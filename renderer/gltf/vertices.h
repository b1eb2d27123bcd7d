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

/// A primitive's attributes; each is empty if it has none, else as long as `positions`.
struct VertexData {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec2> texcoords[2];
  std::vector<glm::vec4> colors;
  std::vector<Influences> influences;
};

/// The source of a primitive's attributes: accessors, or a Draco stream.
class AttributeSource {
 public:
  AttributeSource(const PrimitiveRequest& request, const DracoPrimitive* draco,
                  Accessors& accessors, Warnings& warnings)
      : request_(request), draco_(draco), accessors_(accessors), warnings_(warnings) {}

  /// Returns the number of vertices that POSITION declares.
  [[nodiscard]] Checked<std::size_t> vertex_count() const;
  /// Reads the selected vertices, morphed. Only positions are required: another broken attribute is
  /// left out with a warning.
  [[nodiscard]] Checked<VertexData> read(const Selection& selection);

 private:
  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] Checked<std::vector<float>> floats(const std::string& name, int components,
                                                   const Selection& selection) const;
  [[nodiscard]] Checked<int> components(const std::string& name) const;
  /// Returns `floats` of an optional attribute; broken ones give a warning.
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
