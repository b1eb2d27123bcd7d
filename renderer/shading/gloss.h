#pragma once

#include "renderer/geometry/largest.h"
#include "renderer/scene/scene.h"
#include "renderer/shading/brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asos {

/// A highlight's strength and width.
struct Gloss {
  float f0 = 0.04f;  ///< largest colour component
  float roughness = 1.0f;
  LobeStretch stretch = {};
};

/// The lobes of a surface that may have highlights: its own, and its coat's.
class GlossyLobes {
 public:
  GlossyLobes(const Gloss& base, float coat_factor, float coat_roughness)
      : all_{base, {coat_f0 * coat_factor, coat_roughness}}, count_(coat_factor > 0.0f ? 2 : 1) {}
  explicit GlossyLobes(const SurfaceMaterial& m)
      : GlossyLobes({largest(m.f0), m.roughness, m.stretch}, m.coat.factor, m.coat.roughness) {}

  [[nodiscard]] const Gloss* begin() const { return all_.data(); }
  [[nodiscard]] const Gloss* end() const { return all_.data() + count_; }

 private:
  std::array<Gloss, 2> all_;
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
