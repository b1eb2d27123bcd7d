#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace asos {

/// Smallest roughness of highlights. Below it, the highlight of a punctual light is a few pixels
/// wide and hundreds of times brighter than white. Point samples would hit or miss it by chance,
/// and no method could antialias it. A perfect mirror is shown with this roughness instead.
inline constexpr float roughness_floor = 0.1f;
/// Smallest roughness of broad highlights. They are some 40 degrees wide and vary little more than
/// diffuse reflection, so one sample per pixel is enough.
inline constexpr float least_broad_roughness = 0.6f;

/// Returns the alpha of highlights, the squared roughness.
[[nodiscard]] inline float alpha_of(float roughness) {
  const float floored = std::clamp(roughness, roughness_floor, 1.0f);
  return floored * floored;
}

/// The anisotropy of a GGX lobe, which is rougher along one direction of the tangent plane than
/// across it.
struct LobeStretch {
  /// The direction of greater roughness. Its length is sqrt(at^2 - ab^2), with the alpha `at` along
  /// it and `ab` across. 0: the lobe is isotropic.
  glm::vec3 along{0.0f};
  /// Squared cosine, 0 to 1, between this direction and the viewer in the tangent plane.
  float seen_along2 = 0.0f;

  [[nodiscard]] bool none() const { return along == glm::vec3(0.0f); }
};

/// A lobe of a surface's reflection for one viewer, with Schlick's Fresnel term: GGX (glTF 2.0,
/// appendix B; KHR_materials_anisotropy), or Charlie's for sheen (sheen.h).
struct Lobe {
  glm::vec3 f0{0.0f};      ///< reflectance at normal incidence
  glm::vec3 f90{1.0f};     ///< reflectance at grazing incidence
  float roughness = 0.0f;  ///< across the stretch; sheen has 1, as it is as broad as diffuse light
  LobeStretch stretch = {};
  float sheen = 0.0f;  ///< roughness of Charlie's lobe; 0: the lobe is GGX

  [[nodiscard]] bool is_sheen() const { return sheen > 0.0f; }
  [[nodiscard]] bool is_broad() const { return roughness >= least_broad_roughness; }
  /// Returns the alpha across the stretch, and along it.
  [[nodiscard]] float alpha() const { return alpha_of(roughness); }
  [[nodiscard]] float alpha_along() const;
  /// Returns the roughness in the rougher direction, which decides whether a surface reflects
  /// sharply.
  [[nodiscard]] float widest_roughness() const;
  /// Returns the roughness of the isotropic lobe with the same peak, which determines the blur.
  [[nodiscard]] float round_roughness() const;
  /// Returns the distance of a half vector from the normal. The part along the stretch is scaled by
  /// the ratio of the lobe's widths across and along it. Both vectors are unit.
  [[nodiscard]] float away_from_peak(glm::vec3 normal, glm::vec3 half) const;
};

}  // namespace asos
