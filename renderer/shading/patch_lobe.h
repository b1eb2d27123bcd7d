#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/normal_spread.h"

#include <glm/glm.hpp>

namespace asos {

/// Unit directions from a point to its viewer and to the light, with distances. A distance is
/// infinite where the direction is the same all over a patch.
struct LobeGeometry {
  glm::vec3 to_viewer;
  float viewer_distance;
  glm::vec3 to_light;
  float light_distance;
};

/// Returns the spread of a patch's normals about the half vector. The half vector turns across the
/// patch, too, where viewer or light are near, even on a flat patch.
[[nodiscard]] NormalSpread spread_about_half(const NormalSpread& normals, const Patch& patch,
                                             const LobeGeometry& sight);

/// The GGX lobe of a patch with varying normals: the mean of a highlight smaller than the patch
/// ("geometric specular antialiasing", Kaplanyan et al. 2016). The lobe's squared slopes, a 2x2
/// matrix in the tangent plane, grow by those of the normals. They become anisotropic where normals
/// turn in one direction (Tokuyoshi and Kaplanyan 2021). A normal that turns by d along an edge
/// adds its variance over the patch, d d^T / 12. Wider lobes were measured worse for every method:
/// d d^T / pi keeps the peak of a box of normals, but the long tails of a GGX lobe put light where
/// there is no highlight.
class PatchLobe {
 public:
  /// Largest alpha^2 that a patch adds, summed over both directions. Beyond it, the derivatives of
  /// one triangle's normals do not represent the patch.
  static constexpr float most_added = 0.18f;

  /// `lobe` is GGX.
  PatchLobe(const NormalSpread& spread, const Lobe& lobe, glm::vec3 normal);

  /// Returns false where the lobe is isotropic and the patch's normals vary too little to matter;
  /// then ggx_lobe is the lobe.
  [[nodiscard]] bool wider() const { return wider_; }

  /// Returns the roughness of the isotropic lobe with the same peak. Only for a wider one.
  [[nodiscard]] float round_roughness() const;

  /// D * V in 1 / sr, as ggx_lobe; all directions unit.
  [[nodiscard]] float value(glm::vec3 half, glm::vec3 to_light, glm::vec3 to_viewer,
                            const BrdfAngles& angles) const;

 private:
  bool wider_ = false;
  glm::vec3 tangent_{0.0f};
  glm::vec3 bitangent_{0.0f};
  float xx_ = 0.0f, xy_ = 0.0f, yy_ = 0.0f;  // alpha^2 by direction, as GgxSlopes
};

}  // namespace asos
