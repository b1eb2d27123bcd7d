#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/light_quadrature.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/patch_bend.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// Radiance towards the viewer per irradiance from a light without a size; by the published rule
/// also from those with one: the lobe's part is that of the light's representative point, made as
/// broad as the light by the ratio of what its width was to what it would be (Karis 2013), of the
/// whole light, whatever is visible of it.
[[nodiscard]] glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                                        const ViewedPoint& view, const Highlight& highlight);

/// Radiance towards the viewer per irradiance that comes from one direction: the BRDF, of the patch
/// that the point stands for. `to_light` is unit.
[[nodiscard]] glm::vec3 reflected_towards(const ViewedMaterial& seen, const ViewedPoint& view,
                                          glm::vec3 to_light, float light_distance);

/// Radiance towards the viewer per irradiance by a sample of the light; by the published rule that
/// of the whole light.
[[nodiscard]] glm::vec3 reflected_from(const Illumination& lit, const LightSample& sample);

/// Whether the lobe that makes its highlight is too broad for one: it goes on over all of the
/// light, and beyond.
[[nodiscard]] bool is_broad(const Illumination& lit);

/// By how much the radiance that all of a light would make, were it where its middle is or where
/// one of its corners is, differs: what is seen of it in part may make so much more or less of what
/// is hidden.
[[nodiscard]] float spread_over(const Illumination& lit);

/// The least that a reflection shows for the light to be among it; nothing for a light without a
/// surface: lines and points are too thin, and suns too bright.
[[nodiscard]] std::optional<MirroredLights> shown_from(const PreparedLight& light);
[[nodiscard]] inline bool shows(MirroredLights mirrored, const PreparedLight& light) {
  const auto least = shown_from(light);
  return least && mirrored >= *least;
}

/// What makes a point's lobe wider than its roughness does: how its patch bends, too, or bumps
/// that are narrower than it alone.
enum class Widening { by_patch, by_bumps };

/// What one point makes of its lights, with nothing in the way; or, where that may differ by more
/// than the bend's `negligible`, the mean over its patch, of lights with a size, by the physical
/// rule.
class ReflectedLights {
 public:
  /// `point` has to outlive this.
  explicit ReflectedLights(const LitPoint& point, std::optional<PatchBend> bend = std::nullopt);

  struct Share {
    glm::vec3 reflected{0.0f};  ///< radiance towards the viewer per irradiance
    float highlight = 0.0f;     ///< see Illumination
  };
  /// `irradiance`: of the whole light, not 0. Of lights with a size, by the physical rule, the BRDF
  /// is summed up over the light (LightQuadrature), of a lobe that is as much wider, and round, as
  /// the middle of the highlight finds the patch to make it.
  [[nodiscard]] Share of(const PreparedLight& light, glm::vec3 irradiance);

 private:
  [[nodiscard]] Share of_extended(const PreparedLight& light, const Highlight& highlight,
                                  glm::vec3 irradiance, Widening widening);
  [[nodiscard]] LightQuadrature& quadrature(float roughness);
  [[nodiscard]] glm::vec3 mean(const PreparedLight& light, const PatchBend::Parts& parts) const;

  const LitPoint& point_;
  Receiver receiver_;
  std::optional<PatchBend> bend_;
  glm::dvec3 mirrored_;
  std::optional<LightQuadrature> own_, wider_;  // of the surface, and of the patch
};

}  // namespace asos
