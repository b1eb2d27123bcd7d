#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <utility>

namespace asos::builtin {

/// Collects a built-in scene. Colours are given as people write them, 0xRRGGBB in sRGB.
///
/// Brightness: a white diffuse surface under an illuminance of pi lux has radiance 1, which is
/// display white at exposure 0. So suns have 2 to 3 lux and lamps the candela that give about as
/// much where they matter. There is no ambient light: each scene has a weak fill light from near
/// its camera, whose shadows the subject itself hides, or from the sky.
class Stage {
 public:
  explicit Stage(const std::string& name);

  int paint(const std::string& name, std::uint32_t srgb, float roughness = 0.8f,
            float metallic = 0.0f);
  /// A surface that shines with `nits` times its colour and reflects nothing.
  int glow(const std::string& name, std::uint32_t srgb, float nits);
  void make_double_sided(int material) { scene_.materials[material].double_sided = true; }

  /// Keeps a mesh to be placed, perhaps often; the index is for `place`.
  int keep(const std::string& name, Mesh mesh, int material);
  void place(const std::string& name, int mesh, const glm::dmat4& world_from_mesh);
  /// Keeps a mesh that is built in world coordinates and places it there.
  void add(const std::string& name, Mesh mesh, int material);

  /// `travel`: the way the light goes; any length.
  void sun(const std::string& name, glm::dvec3 travel, std::uint32_t srgb, float lux);
  void lamp(const std::string& name, glm::dvec3 position, std::uint32_t srgb, float candela);
  void spot(const std::string& name, glm::dvec3 position, glm::dvec3 target, std::uint32_t srgb,
            float candela, double outer_cone_deg);

  /// An upright perspective camera; fov is the full vertical angle.
  void camera(const std::string& name, glm::dvec3 eye, glm::dvec3 target, double fov_y_deg);

  [[nodiscard]] Scene take() { return std::move(scene_); }

 private:
  Scene scene_;
};

/// The placement that turns by `degrees` about +Y and then moves to `position`.
[[nodiscard]] glm::dmat4 turned(glm::dvec3 position, double degrees);

}  // namespace asos::builtin
