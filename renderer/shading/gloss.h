#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asos {

/// The lobes of a surface that may have highlights: its own, and its coat's.
class GlossyLobes {
 public:
  GlossyLobes(const Lobe& base, float coat_factor, float coat_roughness)
      : all_{base, {glm::vec3(coat_f0 * coat_factor), glm::vec3(1.0f), coat_roughness}},
        count_(coat_factor > 0.0f ? 2 : 1) {}
  explicit GlossyLobes(const SurfaceMaterial& m)
      : GlossyLobes({m.f0, glm::vec3(1.0f), m.roughness, m.stretch}, m.coat.factor,
                    m.coat.roughness) {}

  [[nodiscard]] const Lobe* begin() const { return all_.data(); }
  [[nodiscard]] const Lobe* end() const { return all_.data() + count_; }

 private:
  std::array<Lobe, 2> all_;
  std::size_t count_;
};

/// Smoother lobes are so narrow that a square of directions represents them.
inline constexpr float least_lobe_roughness = 1.0f / 64.0f;

/// Returns whether a lobe of this roughness has highlights that are shaded, not traced as
/// reflections, and vary faster than diffuse reflection.
[[nodiscard]] inline bool has_highlights(float roughness) {
  return roughness >= roughness_floor && roughness < least_broad_roughness;
}

/// Returns the roughness of the smoothest layer of a material, without textures, which can only
/// reduce it.
[[nodiscard]] inline float least_roughness(const Material& m) {
  return m.coat.factor > 0.0f ? std::min(m.roughness, m.coat.roughness) : m.roughness;
}

/// Returns the roughness of the smoothest layer that may reflect sharply. An anisotropic layer
/// counts with its rougher direction.
[[nodiscard]] inline float least_mirror_roughness(const Material& m) {
  if (!m.anisotropy.used() || m.anisotropy.texture.used()) return least_roughness(m);
  const float across = m.roughness * m.roughness, strength = m.anisotropy.strength;
  const float base = std::sqrt(across + (1.0f - across) * strength * strength);
  return m.coat.factor > 0.0f ? std::min(base, m.coat.roughness) : base;
}

/// Returns the largest fraction of a material's base colour that is reflected diffusely. It is less
/// than 1 where a volume's boundary transmits light.
[[nodiscard]] inline float diffuse_share(const Material& m) {
  return bounds_volume(m) && !m.transmission_texture.used() ? 1.0f - m.transmission : 1.0f;
}

/// Returns whether a material's highlights may vary faster than diffuse reflection.
[[nodiscard]] inline bool may_be_glossy(const Material& m) {
  return m.metallic_roughness_texture.used() || least_roughness(m) < least_broad_roughness;
}

}  // namespace asos
