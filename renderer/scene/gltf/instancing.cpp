#include "renderer/scene/gltf/instancing.h"

#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

/// The copies' values of one attribute; empty where the extension has none.
Checked<std::vector<float>> values_of(const tinygltf::Value& attributes, const char* name,
                                      int components, Accessors& accessors) {
  const std::optional<int> accessor = whole(attributes, name);
  if (!accessor) return std::vector<float>();
  return accessors.floats(*accessor, components);
}

bool all_finite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

glm::dvec3 vector_at(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

Checked<std::vector<NodePose>> read_copies(const tinygltf::Value& attributes,
                                           const std::string& place, Accessors& accessors,
                                           Warnings& warnings) {
  const auto translations = values_of(attributes, "TRANSLATION", 3, accessors);
  const auto rotations = values_of(attributes, "ROTATION", 4, accessors);
  const auto scales = values_of(attributes, "SCALE", 3, accessors);
  for (const auto* values : {&translations, &rotations, &scales}) {
    if (!*values) return fault(values->error());
    if (!all_finite(**values)) return fault("its values are not finite");
  }
  const std::size_t count =
      std::max({translations->size() / 3, rotations->size() / 4, scales->size() / 3});
  const auto fits = [&](std::size_t size, std::size_t n) { return size == 0 || size / n == count; };
  if (!fits(translations->size(), 3) || !fits(rotations->size(), 4) || !fits(scales->size(), 3)) {
    return fault("its attributes differ in length");
  }
  std::vector<NodePose> poses(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!translations->empty()) poses[i].translation = vector_at(*translations, i);
    if (!scales->empty()) poses[i].scale = vector_at(*scales, i);
    if (!rotations->empty()) {
      const float* r = rotations->data() + i * 4;
      poses[i].rotation = unit_rotation(glm::dquat(r[3], r[0], r[1], r[2]), place, warnings);
    }
  }
  return poses;
}

}  // namespace

std::vector<glm::dmat4> instance_matrices(const tinygltf::Node& node, const std::string& place,
                                          Accessors& accessors, Warnings& warnings) {
  const std::vector<glm::dmat4> once{glm::dmat4(1.0)};
  const tinygltf::Value* ext = extension(node.extensions, "EXT_mesh_gpu_instancing");
  if (!ext || !ext->Has("attributes")) return once;
  const auto poses = read_copies(ext->Get("attributes"), place, accessors, warnings);
  if (!poses) {
    warnings.add(fmt::format("{}: its instancing is left out: {}", place, poses.error()));
    return once;
  }
  if (poses->empty()) return once;
  std::vector<glm::dmat4> matrices;
  matrices.reserve(poses->size());
  for (const NodePose& pose : *poses) matrices.push_back(pose.parent_from_node());
  return matrices;
}

}  // namespace asos::gltf
