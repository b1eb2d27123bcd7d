#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/light_quadrature.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/patch_curvature.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// Returns the radiance towards the viewer per irradiance from a point light, or by the published
/// rule from any light. The specular part uses the light's representative point and is normalized
/// by the ratio of its width without and with the light's extent (Karis 2013). It is that of the
/// whole light, whatever part is visible.
[[nodiscard]] glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                                        const ViewedPoint& view, const Highlight& highlight);

/// Returns the radiance towards the viewer per irradiance from one direction: the BRDF of the
/// point's patch. `to_light` is unit.
[[nodiscard]] glm::vec3 reflected_towards(const ViewedMaterial& seen, const ViewedPoint& view,
                                          glm::vec3 to_light, float light_distance);

/// Returns the radiance towards the viewer per irradiance from a sample of the light; by the
/// published rule, that of the whole light.
[[nodiscard]] glm::vec3 reflected_from(const Illumination& lit, const LightSample& sample);

/// Returns whether the highlight's lobe is too broad for a highlight: it extends over the whole
/// light and beyond.
[[nodiscard]] bool is_broad(const Illumination& lit);

/// Returns the largest difference between the contributions if the whole light were at its centre
/// or near one of its corners. It bounds the error of a partially occluded light's contribution.
[[nodiscard]] float spread_over(const Illumination& lit);

/// Returns the least value of MirroredLights that includes the light. Returns nothing for a light
/// without a surface, since lines and points are too thin, and for suns, which are too bright.
[[nodiscard]] std::optional<MirroredLights> shown_from(const PreparedLight& light);
[[nodiscard]] inline bool shows(MirroredLights mirrored, const PreparedLight& light) {
  const auto least = shown_from(light);
  return least && mirrored >= *least;
}

/// Causes that widen a point's lobe beyond its roughness: its patch's curvature and bumps, or only
/// bumps smaller than the patch.
enum class Widening { by_patch, by_bumps };

/// Unshadowed contributions of the lights to one point. For lights with an extent, by the physical
/// rule, they are means over the point's patch where its centre may differ from the mean by more
/// than PatchCurvature::negligible or 1/1024 of the radiance.
class ReflectedLights {
 public:
  /// `point` has to outlive this.
  explicit ReflectedLights(const LightingQuery& point,
                           std::optional<PatchCurvature> bend = std::nullopt);

  struct LightReflection {
    glm::vec3 reflected{0.0f};  ///< radiance towards the viewer per irradiance
    float highlight = 0.0f;     ///< see Illumination
  };
  /// Returns the reflection of a light. `irradiance` is that of the whole light, not 0. For a light
  /// with an extent, by the physical rule, the BRDF is integrated over the light (LightQuadrature).
  /// The patch widens the lobe equally in all directions, as at the highlight's centre.
  [[nodiscard]] LightReflection of(const PreparedLight& light, glm::vec3 irradiance);

 private:
  [[nodiscard]] LightReflection of_extended(const PreparedLight& light, const Highlight& highlight,
                                            glm::vec3 irradiance, Widening widening);
  [[nodiscard]] LightQuadrature& quadrature(float roughness);
  [[nodiscard]] glm::vec3 mean(const PreparedLight& light,
                               const PatchCurvature::Parts& parts) const;

  const LightingQuery& point_;
  Receiver receiver_;
  std::optional<PatchCurvature> bend_;
  glm::dvec3 mirrored_;
  std::optional<LightQuadrature> own_, wider_;  // of the surface, and of the patch
};

}  // namespace asos
