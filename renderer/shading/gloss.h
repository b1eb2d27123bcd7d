#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/brdf.h"

#include <algorithm>
#include <cmath>

namespace asos {

/// A highlight's strength and width.
struct Gloss {
  float f0 = 0.04f;  ///< largest of the colours
  float roughness = 1.0f;
};

/// Whether a lobe of this roughness has highlights that are no reflections, and vary faster than
/// diffuse light does.
[[nodiscard]] inline bool has_highlights(float roughness) {
  return roughness >= roughness_floor && roughness < least_broad_roughness;
}

/// The roughness of the smoothest of a material's layers, without textures, which only lessen it.
[[nodiscard]] inline float least_roughness(const Material& m) {
  return m.coat.factor > 0.0f ? std::min(m.roughness, m.coat.roughness) : m.roughness;
}

/// The same of those that may mirror: what anisotropy draws out goes by its rougher direction.
[[nodiscard]] inline float least_mirror_roughness(const Material& m) {
  if (!m.anisotropy.used() || m.anisotropy.texture.used()) return least_roughness(m);
  const float across = m.roughness * m.roughness, strength = m.anisotropy.strength;
  const float base = std::sqrt(across + (1.0f - across) * strength * strength);
  return m.coat.factor > 0.0f ? std::min(base, m.coat.roughness) : base;
}

/// The share of its base colour that it may reflect diffusely: none where a volume's boundary lets
/// all through.
[[nodiscard]] inline float diffuse_share(const Material& m) {
  return bounds_volume(m) && !m.transmission_texture.used() ? 1.0f - m.transmission : 1.0f;
}

/// Whether highlights on it vary faster than diffuse light does.
[[nodiscard]] inline bool may_be_glossy(const Material& m) {
  return m.metallic_roughness_texture.used() || least_roughness(m) < least_broad_roughness;
}

}  // namespace asos
