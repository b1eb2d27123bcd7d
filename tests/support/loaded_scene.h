#pragma once

#include "renderer/gltf/load.h"
#include "renderer/gltf/validate_light.h"
#include "renderer/scene/validate_scene.h"
#include "renderer/world/world.h"
#include "tests/support/flat_world.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace asos::test {

/// Names the layer of a material, or of its base, that violates a guarantee; null: none.
inline const char* broken_layer_of(const Material& m) {
  const auto share = [](float value) { return value >= 0.0f && value <= 1.0f; };
  const auto shares = [&](glm::vec3 v) { return share(v.x) && share(v.y) && share(v.z); };
  const auto size = [](float value) { return value >= 0.0f && std::isfinite(value); };
  if (!share(m.coat.factor) || !share(m.coat.roughness)) return "a coat";
  if (!shares(m.sheen.color) || !share(m.sheen.roughness)) return "a sheen";
  if (!share(m.film.factor) || !(m.film.ior >= 1.0f && std::isfinite(m.film.ior)) ||
      !size(m.film.thickness_min_nm) || !size(m.film.thickness_max_nm))
    return "a film";
  if (!share(m.transmission) || !size(m.volume.thickness) ||
      !(m.volume.attenuation_distance > 0.0f) || !shares(m.volume.attenuation_color) ||
      !size(m.volume.dispersion))
    return "a volume";
  if (!share(m.diffuse_transmission.factor) || !shares(m.diffuse_transmission.color))
    return "what shines through";
  return nullptr;
}

inline std::string broken_promise_of(const Material& m) {
  const auto share = [](double value) { return value >= 0.0 && value <= 1.0; };
  if (m.ior != 0.0f && !(m.ior >= 1.0f && std::isfinite(m.ior))) return "an index of refraction";
  if (!share(m.specular)) return "a specular factor";
  for (int c = 0; c < 3; ++c)
    if (!(m.specular_color[c] >= 0.0f && std::isfinite(m.specular_color[c])))
      return "a specular colour";
  if (const char* broken = broken_layer_of(m)) return broken;
  if (!m.dfr) return "";
  if (!share(m.dfr->perturbation)) return "a perturbation";
  for (const DfrCurve& curve : m.dfr->rgb)
    if (!share(curve.min) || !share(curve.max) ||
        !(curve.exponent >= 0.0 && std::isfinite(curve.exponent)))
      return "a defocusing ratio";
  return "";
}

/// Names the guarantee of the headers that a loaded scene violates; empty: none.
inline std::string broken_promise_of(const Result<Scene>& scene, const std::string& path) {
  if (!scene) {
    if (scene.error().subject != path) return "the error names the file";
    return scene.error().reason.empty() ? "the error has a reason" : "";
  }
  if (std::string fault = validate_scene(*scene); !fault.empty()) return fault;
  for (const Mesh& mesh : scene->meshes) {
    if (mesh.normals.size() != mesh.positions.size() && !mesh.has_lines())
      return "each vertex has a normal";
    for (const glm::vec3 p : mesh.positions)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return "positions are finite";
  }
  for (const Material& material : scene->materials)
    if (std::string broken = broken_promise_of(material); !broken.empty()) return broken;
  for (const Light& light : scene->lights)
    if (const std::string fault = gltf::validate_light(light); !fault.empty())
      return fmt::format("light '{}' {}", light.name, fault);
  const Result<World> world = flat_world(*scene);
  if (!world) {
    // Only sizes may be rejected here: the importer checks everything else.
    const std::string& reason = world.error().reason;
    const bool of_size = reason.find("units across") != std::string::npos ||
                         reason.find("single precision") != std::string::npos ||
                         reason.find("not finite") != std::string::npos;
    return of_size ? "" : "the importer lets through: " + reason;
  }
  const Camera camera = default_camera(*world, 1.5);
  return std::isfinite(camera.world_from_camera[3].x) ? "" : "a camera frames the scene";
}

}  // namespace asos::test
