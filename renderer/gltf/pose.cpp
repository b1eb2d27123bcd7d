#include "renderer/gltf/nodes.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <cmath>

namespace asos::gltf {

namespace {

bool all_finite(const std::vector<double>& values) {
  for (const double v : values) {
    if (!std::isfinite(v)) return false;
  }
  return true;
}

/// Returns whether `values` has `count` finite entries; an absent property gives no warning.
bool usable(const std::vector<double>& values, std::size_t count, const std::string& place,
            const char* what, Warnings& warnings) {
  if (values.empty()) return false;
  if (values.size() == count && all_finite(values)) return true;
  warnings.add(fmt::format("{}: its {} is not {} finite numbers; ignored", place, what, count));
  return false;
}

glm::dmat4 matrix_of(const std::vector<double>& values, const std::string& place,
                     Warnings& warnings) {
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = values[static_cast<std::size_t>(i)];
  if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0) {
    warnings.add(place + ": its matrix is not affine; its last row is ignored");
    m[0][3] = m[1][3] = m[2][3] = 0.0;
    m[3][3] = 1.0;
  }
  for (int a = 0; a < 3; ++a) {
    const glm::dvec3 x(m[a]), y(m[(a + 1) % 3]);
    if (std::abs(glm::dot(x, y)) > 1e-3 * glm::length(x) * glm::length(y)) {
      warnings.add(place + ": its matrix is sheared, which glTF does not allow; drawn as it is");
    }
  }
  return m;
}

NodePose pose_at_rest(const tinygltf::Node& node, const std::string& place, Warnings& warnings) {
  NodePose pose;
  if (usable(node.matrix, 16, place, "matrix", warnings)) {
    pose.matrix = matrix_of(node.matrix, place, warnings);
  }
  if (usable(node.translation, 3, place, "translation", warnings)) {
    pose.translation = {node.translation[0], node.translation[1], node.translation[2]};
  }
  if (usable(node.rotation, 4, place, "rotation", warnings)) {
    pose.rotation = unit_rotation(
        glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]), place,
        warnings);
  }
  if (usable(node.scale, 3, place, "scale", warnings)) {
    pose.scale = {node.scale[0], node.scale[1], node.scale[2]};
  }
  pose.weights = node.weights;
  if (const auto* e = extension(node.extensions, "KHR_node_visibility"))
    pose.visible = flag(*e, "visible").value_or(true);
  return pose;
}

}  // namespace

glm::dquat unit_rotation(glm::dquat q, const std::string& place, Warnings& warnings) {
  const double length = glm::length(q);
  if (!(length > 1e-12) || !std::isfinite(length)) {
    warnings.add(place + ": its rotation has no direction; ignored");
    return {1.0, 0.0, 0.0, 0.0};
  }
  if (std::abs(length - 1.0) > 0.01) warnings.add(place + ": its rotation was not normalised");
  return q * (1.0 / length);
}

std::vector<NodePose> poses_at_rest(Document& doc) {
  std::vector<NodePose> poses;
  poses.reserve(doc.model.nodes.size());
  for (std::size_t i = 0; i < doc.model.nodes.size(); ++i) {
    poses.push_back(pose_at_rest(doc.model.nodes[i], fmt::format("node {}", i), doc.warnings));
  }
  return poses;
}

}  // namespace asos::gltf
