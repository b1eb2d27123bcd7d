#pragma once

#include "renderer/gltf/load.h"
#include "renderer/scene/posable_scene.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace asos::test {

/// Adds a channel with its sampler to the file's first animation, which is created if missing.
inline void add_channel(GltfBuilder& b, int node, const std::string& path, int times, int values,
                        const std::string& interpolation = "LINEAR") {
  if (!b.json.contains("animations"))
    b.json["animations"] = {
        {{"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}}};
  nlohmann::json& animation = b.json["animations"][0];
  animation["samplers"].push_back(
      {{"input", times}, {"output", values}, {"interpolation", interpolation}});
  animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                   {"target", {{"node", node}, {"path", path}}}});
}

/// A quaternion (x, y, z, w) for a rotation about z.
inline glm::vec4 about_z(double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  return {0, 0, std::sin(half), std::cos(half)};
}

/// The file's scene at rest with its rig; stops the test on an error.
inline Scene with_rig(const GltfBuilder& b) {
  const TemporaryFolder folder;
  Result<Scene> scene = import_gltf(folder.write("test.glb", b.glb()), {.keep_posable = true});
  if (!scene) throw std::runtime_error(scene.error().message());
  return std::move(*scene);
}

inline Scene posed(const Scene& scene, double seconds, int animation = 0) {
  if (!scene.rig) throw std::runtime_error("there is no rig");
  Result<Scene> pose = scene.rig->pose(ClipTime{animation, seconds});
  if (!pose) throw std::runtime_error(pose.error().message());
  return std::move(*pose);
}

/// A vertex of an instance's mesh, in the world.
inline glm::dvec3 world_vertex(const Scene& scene, std::size_t vertex, std::size_t instance = 0) {
  const Instance& placed = scene.instances.at(instance);
  const Mesh& mesh = scene.meshes.at(static_cast<std::size_t>(placed.mesh));
  return placed.world_from_mesh * glm::dvec4(mesh.positions.at(vertex), 1.0);
}

}  // namespace asos::test
