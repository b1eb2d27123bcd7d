#include "renderer/gltf/skin.h"

#include <fmt/format.h>

#include <cmath>

namespace asos::gltf {

namespace {

glm::dmat4 matrix_at(const std::vector<float>& values, std::size_t index) {
  glm::dmat4 m;
  for (std::size_t i = 0; i < 16; ++i) {
    m[static_cast<int>(i / 4)][static_cast<int>(i % 4)] =
        static_cast<double>(values[index * 16 + i]);
  }
  // Only affine matrices are allowed; exporters leave rounding errors in the last row.
  m[0][3] = m[1][3] = m[2][3] = 0.0;
  m[3][3] = 1.0;
  return m;
}

/// Returns the inverse transpose times the absolute value of the determinant: for normals, also of
/// mirrored parts.
glm::dmat3 normal_matrix(const glm::dmat4& m, double determinant) {
  const glm::dvec3 a(m[0]), b(m[1]), c(m[2]);
  const double sign = determinant < 0.0 ? -1.0 : 1.0;
  return {sign * glm::cross(b, c), sign * glm::cross(c, a), sign * glm::cross(a, b)};
}

/// The weighted sum of the joints' matrices, or the node's matrix for a vertex without weights.
class Blend {
 public:
  Blend(const VertexData& data, const PrimitiveRequest& request) : data_(data), request_(request) {}

  glm::dmat4 at(std::size_t vertex) {
    glm::dmat4 sum(0.0);
    double total = 0.0;
    for (const Influences& set : data_.influences) {
      for (int i = 0; i < 4; ++i) {
        const double weight = static_cast<double>(set.weights[vertex][i]);
        const std::uint32_t joint = set.joints[vertex][i];
        if (weight == 0.0) continue;
        if (!(weight > 0.0) || !std::isfinite(weight) || joint >= request_.skin->joints.size()) {
          ++ignored;
          continue;
        }
        sum += weight * request_.skin->joints[joint];
        total += weight;
      }
    }
    if (total == 0.0) {
      ++unweighted;
      return request_.world_from_node;
    }
    if (std::abs(total - 1.0) > 0.01) ++not_normalised;
    return sum * (1.0 / total);
  }

  std::size_t ignored = 0, unweighted = 0, not_normalised = 0;

 private:
  const VertexData& data_;
  const PrimitiveRequest& request_;
};

void warn(const Blend& blend, const std::string& place, Warnings& warnings) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) warnings.add(fmt::format("{}: {} {}", place, count, what));
  };
  say(blend.ignored, "joint weights are negative or of joints that do not exist; ignored");
  say(blend.unweighted, "vertices have no joint weights; they go with their node");
  say(blend.not_normalised, "vertices have joint weights that do not add up to 1; normalised");
}

}  // namespace

Checked<SkinPose> skin_pose(Document& doc, Accessors& accessors, const NodeGraph& graph,
                            int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= doc.model.skins.size()) {
    return fault(fmt::format("skin {} does not exist", index));
  }
  const tinygltf::Skin& skin = doc.model.skins[static_cast<std::size_t>(index)];
  if (skin.joints.empty()) return fault(fmt::format("skin {} has no joints", index));
  const auto exists = [&](int node) {
    return node >= 0 && static_cast<std::size_t>(node) < graph.size();
  };
  if (skin.skeleton >= 0 && !exists(skin.skeleton)) {
    doc.warnings.add(fmt::format("skin {}: its skeleton does not exist", index));
  }
  std::vector<float> inverse_bind;
  if (skin.inverseBindMatrices >= 0) {
    Checked<std::vector<float>> values = accessors.floats(skin.inverseBindMatrices, 16);
    if (values) {
      inverse_bind = std::move(*values);
    } else {
      doc.warnings.add(
          fmt::format("skin {}: its bind matrices are left out: {}", index, values.error()));
    }
    if (values && inverse_bind.size() / 16 < skin.joints.size()) {
      doc.warnings.add(fmt::format("skin {}: {} bind matrices for {} joints", index,
                                   inverse_bind.size() / 16, skin.joints.size()));
    }
  }
  SkinPose pose;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    const int node = skin.joints[j];
    if (!exists(node)) {
      doc.warnings.add(fmt::format("skin {}: joint node {} does not exist", index, node));
      pose.joints.emplace_back(1.0);
      continue;
    }
    const bool bound = (j + 1) * 16 <= inverse_bind.size();
    const glm::dmat4& joint = graph.world_from_node(node);
    pose.joints.push_back(bound ? joint * matrix_at(inverse_bind, j) : joint);
  }
  return pose;
}

glm::dvec3 apply_skin(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const PrimitiveRequest& request, Warnings& warnings) {
  Blend blend(data, request);
  glm::dvec3 offset(0.0);
  bool has_offset = false;
  std::size_t mirrored = 0;
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    const glm::dmat4 m = blend.at(v);
    const double determinant = glm::determinant(glm::dmat3(m));
    if (determinant < 0.0) ++mirrored;
    const glm::dvec3 world(m * glm::dvec4(data.positions[v], 1.0));
    if (!has_offset && std::isfinite(world.x) && std::isfinite(world.y) && std::isfinite(world.z)) {
      offset = world;
      has_offset = true;
    }
    data.positions[v] = glm::vec3(world - offset);
    if (!data.normals.empty()) {
      const glm::dvec3 n = normal_matrix(m, determinant) * glm::dvec3(data.normals[v]);
      const double length = glm::length(n);
      data.normals[v] = length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f);
    }
    if (!data.tangents.empty()) {
      const glm::dvec3 t = glm::dmat3(m) * glm::dvec3(data.tangents[v]);
      const double length = glm::length(t);
      const float side = determinant < 0.0 ? -data.tangents[v].w : data.tangents[v].w;
      data.tangents[v] = glm::vec4(length > 0.0 ? glm::vec3(t / length) : glm::vec3(0.0f), side);
    }
  }
  warn(blend, request.place, warnings);
  if (mirrored * 2 > data.positions.size()) {
    for (glm::uvec3& t : triangles) std::swap(t.y, t.z);
  }
  return offset;
}

}  // namespace asos::gltf
