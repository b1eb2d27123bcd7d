#include "renderer/scene/gltf/nodes.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <utility>

namespace asos::gltf {

namespace {

bool all_finite(const std::vector<double>& values) {
  for (const double v : values) {
    if (!std::isfinite(v)) return false;
  }
  return true;
}

/// `values` if it has `count` finite entries; an absent property is not worth a warning.
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
  return pose;
}

std::size_t morph_target_count(const Document& doc, const tinygltf::Node& node) {
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= doc.model.meshes.size()) return 0;
  const tinygltf::Mesh& mesh = doc.model.meshes[static_cast<std::size_t>(node.mesh)];
  return mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
}

/// The first key's value: `count` groups of `components` numbers. Key times are at least 0, and
/// before the first key an animation holds its value.
Checked<std::vector<float>> first_value(const tinygltf::AnimationSampler& sampler,
                                        Accessors& accessors, std::uint32_t count, int components) {
  if (auto times = accessors.floats(sampler.input, 1, std::vector<std::uint32_t>{0}); !times) {
    return times;
  } else if (!(times->front() >= 0.0f)) {
    return fault("its first key is before time 0");
  }
  // A cubic spline's key is its in-tangent, its value and its out-tangent.
  const std::uint32_t first = sampler.interpolation == "CUBICSPLINE" ? count : 0;
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t i = 0; i < count; ++i) wanted.push_back(first + i);
  auto values = accessors.floats(sampler.output, components, wanted);
  if (!values) return values;
  for (const float v : *values) {
    if (!std::isfinite(v)) return fault("its first value is not finite");
  }
  return values;
}

Checked<void> apply_channel(const tinygltf::AnimationChannel& channel,
                            const tinygltf::Animation& animation, Document& doc,
                            Accessors& accessors, std::vector<NodePose>& poses) {
  const auto node = static_cast<std::size_t>(channel.target_node);
  if (channel.target_node < 0) return {};  // glTF: such channels are to be ignored
  if (node >= poses.size()) return fault("its node does not exist");
  if (channel.sampler < 0 || static_cast<std::size_t>(channel.sampler) >= animation.samplers.size())
    return fault("its sampler does not exist");
  const auto& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
  NodePose& pose = poses[node];
  const std::string& path = channel.target_path;
  if (path == "weights") {
    const std::size_t count = morph_target_count(doc, doc.model.nodes[node]);
    if (count == 0) return fault("its node has nothing to morph");
    const auto v = first_value(sampler, accessors, static_cast<std::uint32_t>(count), 1);
    if (!v) return fault(v.error());
    pose.weights.assign(v->begin(), v->end());
    return {};
  }
  if (path != "translation" && path != "rotation" && path != "scale") {
    return fault(fmt::format("its path '{}' is not supported", path));
  }
  if (pose.matrix) return fault("its node has a matrix, which cannot be animated");
  const auto v = first_value(sampler, accessors, 1, path == "rotation" ? 4 : 3);
  if (!v) return fault(v.error());
  const auto at = [&](std::size_t i) { return static_cast<double>((*v)[i]); };
  if (path == "translation") pose.translation = {at(0), at(1), at(2)};
  if (path == "scale") pose.scale = {at(0), at(1), at(2)};
  if (path == "rotation") {
    pose.rotation = unit_rotation(glm::dquat(at(3), at(0), at(1), at(2)),
                                  fmt::format("node {} in animation 0", node), doc.warnings);
  }
  return {};
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

std::vector<NodePose> pose_at_start(Document& doc, Accessors& accessors) {
  std::vector<NodePose> poses;
  poses.reserve(doc.model.nodes.size());
  for (std::size_t i = 0; i < doc.model.nodes.size(); ++i) {
    poses.push_back(pose_at_rest(doc.model.nodes[i], fmt::format("node {}", i), doc.warnings));
  }
  if (doc.model.animations.empty()) return poses;
  const tinygltf::Animation& animation = doc.model.animations.front();
  if (animation.channels.empty()) doc.warnings.add("animation 0 has no channels");
  std::set<std::pair<int, std::string>> targets;
  for (std::size_t i = 0; i < animation.channels.size(); ++i) {
    const tinygltf::AnimationChannel& channel = animation.channels[i];
    Checked<void> done = fault("another channel moves the same target");
    if (channel.target_node < 0 || targets.emplace(channel.target_node, channel.target_path).second)
      done = apply_channel(channel, animation, doc, accessors, poses);
    if (!done) {
      doc.warnings.add(fmt::format("animation 0, channel {}: {}; ignored", i, done.error()));
    }
  }
  return poses;
}

}  // namespace asos::gltf
