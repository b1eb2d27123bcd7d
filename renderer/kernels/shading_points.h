#pragma once

#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace asos {

/// Shading points as arrays, as many as a kernel processes at a time. Holds the data of
/// LightingQuery. Lanes beyond `count` are undefined.
struct ShadingPoints {
  static constexpr std::size_t size = 256;  ///< a multiple of the lanes of all processors

  struct alignas(64) Floats : std::array<float, size> {};
  struct Vectors {
    Floats x{}, y{}, z{};
    void set(std::size_t i, glm::vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
    [[nodiscard]] glm::vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  };

  std::size_t count = 0;
  Vectors position;   ///< where light arrives
  Vectors geometric;  ///< normal of the horizon
  Vectors normal;     ///< shading normal
  Vectors to_viewer;
  Floats clear_height{};
  Floats to_edge{};
  Floats n_dot_v{};
  // With s = (1 - v.h)^5, radiance per irradiance is diffuse (1 - falloff s) + (f0 + (f90 - f0) s)
  // lobe. All but falloff include the point's weight (see `add`).
  Vectors diffuse;
  Floats falloff{};
  Vectors f0;
  Vectors f90_less_f0;
  Floats alpha{};            ///< squared roughness, floored
  Floats shows_lights{};     ///< MirroredLights as a number
  Floats turns{};            ///< 0 where the following fields are 0; else 1
  Floats sheen{};            ///< as in Lobe
  Vectors stretch;           ///< LobeStretch::along; only where `turns` is 1
  Floats viewer_nearness{};  ///< 1 / distance
  Vectors patch_right, patch_down;
  Vectors spread_right, spread_down;
  Floats spread_variance{};

  [[nodiscard]] bool full() const { return count == size; }
  /// Adds a point whose reflectance is multiplied by `weight`. The batch must not be full.
  void add(const LightingQuery& point, glm::vec3 weight);
  /// Sets the material of a point of the batch, with reflectance multiplied by `share`.
  void set_material(std::size_t i, const ViewedMaterial& material, glm::vec3 share);
  /// Multiplies the reflectance of a point of the batch.
  void weigh(std::size_t i, glm::vec3 weight) {
    for (Vectors* reflectance : {&diffuse, &f0, &f90_less_f0})
      reflectance->set(i, weight * reflectance->at(i));
  }
  /// Adds a point without material or viewer; their fields are not set.
  void add(const SurfacePoint& point);
  /// Fills the batch with `times` copies of its first point, at most `size`.
  void repeat_first(std::size_t times, bool with_material);
  /// Copies the points of another batch with these indices, fewer than `size`.
  void gather(const ShadingPoints& from, std::span<const std::uint32_t> indices);
  void set_mirrored(std::size_t i, MirroredLights shown) {
    shows_lights[i] = static_cast<float>(shown);
  }
};

}  // namespace asos
