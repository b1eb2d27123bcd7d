#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/normal_spread.h"

#include <glm/glm.hpp>

namespace asos {

/// Unit directions from a point to who looks at it and to the light, and how far they are: infinite
/// where the directions are the same all over a patch.
struct LobeSight {
  glm::vec3 to_viewer;
  float viewer_distance;
  glm::vec3 to_light;
  float light_distance;
};

/// How a patch's normals are spread about the half vector, which turns across the patch too where
/// viewer or light are near: what a highlight sees of the patch, also of a flat one.
[[nodiscard]] NormalSpread spread_about_half(const NormalSpread& normals, const Patch& patch,
                                             const LobeSight& sight);

/// The GGX lobe of a patch whose normals differ: what a highlight smaller than the patch is on
/// average ("geometric specular antialiasing", Kaplanyan et al. 2016). The squared slopes of the
/// lobe, a 2x2 matrix in the tangent plane, grow by the normals' own, anisotropic where they turn
/// one way (Tokuyoshi and Kaplanyan 2021): a normal that turns by d along an edge adds its variance
/// over the patch, d d^T / 12. Wider lobes (d d^T / pi keeps the peak of a box of normals) put
/// light where no highlight is, for a GGX lobe's tails are long, and were measured worse for every
/// method.
class PatchLobe {
 public:
  /// Squared roughness that a patch adds at most, over both directions. Beyond, the normals at hand
  /// (the derivatives of one triangle) do not tell what the patch shows.
  static constexpr float most_added = 0.18f;

  /// `stretch`: LobeStretch's `along`, of a lobe that is not round by itself.
  PatchLobe(const NormalSpread& spread, float roughness, glm::vec3 normal,
            glm::vec3 stretch = glm::vec3(0.0f));

  /// False where the lobe is round, and the patch's normals differ too little to show: ggx_lobe is
  /// the lobe.
  [[nodiscard]] bool wider() const { return wider_; }

  /// Only of a wider one: the roughness of the round lobe with the same peak.
  [[nodiscard]] float round_roughness() const;

  /// D * V in 1 / sr, as ggx_lobe; all directions unit.
  [[nodiscard]] float value(glm::vec3 half, glm::vec3 to_light, glm::vec3 to_viewer,
                            const BrdfAngles& angles) const;

 private:
  /// v^T A v for the part of v in the tangent plane.
  [[nodiscard]] float quadratic(glm::vec3 v) const;

  bool wider_ = false;
  glm::vec3 tangent_{0.0f};
  glm::vec3 bitangent_{0.0f};
  float xx_ = 0.0f, xy_ = 0.0f, yy_ = 0.0f;  // A: alpha^2 by direction
};

}  // namespace asos
