#include "renderer/gltf/instancing.h"

#include "renderer/gltf/nodes.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

/// Returns the copies' values of one attribute; empty if the extension has none.
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

Checked<std::vector<glm::dmat4>> read_copies(const tinygltf::Value& attributes,
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
  std::vector<glm::dmat4> matrices;
  matrices.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    NodePose pose;
    if (!translations->empty()) pose.translation = vector_at(*translations, i);
    if (!scales->empty()) pose.scale = vector_at(*scales, i);
    if (!rotations->empty()) {
      const float* r = rotations->data() + i * 4;
      pose.rotation = unit_rotation(glm::dquat(r[3], r[0], r[1], r[2]), place, warnings);
    }
    matrices.push_back(pose.parent_from_node());
  }
  return matrices;
}

}  // namespace

Checked<std::vector<glm::dmat4>> instance_matrices(const tinygltf::Node& node,
                                                   const std::string& place, std::size_t most,
                                                   Accessors& accessors, Warnings& warnings) {
  std::vector<glm::dmat4> once{glm::dmat4(1.0)};
  const tinygltf::Value* ext = extension(node.extensions, "EXT_mesh_gpu_instancing");
  if (!ext) return once;
  const tinygltf::Value& attributes = ext->Get("attributes");
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"}) {
    const Checked<std::uint64_t> count =
        accessors.declared_count(whole(attributes, name).value_or(-1));
    if (count && *count > most)
      return fault(fmt::format("has more than {} objects, which is the limit", most));
  }
  Checked<std::vector<glm::dmat4>> copies = read_copies(attributes, place, accessors, warnings);
  if (copies && !copies->empty()) return copies;
  warnings.add(fmt::format("{}: its instancing is left out: {}", place,
                           copies ? "it places no copies" : copies.error()));
  return once;
}

}  // namespace asos::gltf
