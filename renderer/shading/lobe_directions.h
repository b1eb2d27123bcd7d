#pragma once

#include "renderer/shading/brdf.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// Samples directions of a GGX lobe by visible normals, reflected or refracted (Heitz 2018,
/// "Sampling the GGX Distribution of Visible Normals"). Stores all that does not depend on the
/// sample.
class LobeDirections {
 public:
  /// Smallest squared roughness along both directions.
  static constexpr float least_alpha = 1e-4f;

  /// `spread` is added to the lobe's alpha^2, for bumps smaller than a sample. All directions are
  /// unit.
  LobeDirections(const Lobe& lobe, float spread, glm::vec3 normal, glm::vec3 to_viewer);

  struct Direction {
    glm::vec3 unit{0.0f};
    /// Weight of the radiance from there in the radiance towards the viewer.
    glm::vec3 weight{0.0f};
  };
  /// Returns the reflected direction of a place in the unit square. The mean over places of
  /// radiance times weight is the integral of radiance, lobe, Fresnel's term and cosine over the
  /// normal's hemisphere. Returns none below it.
  [[nodiscard]] std::optional<Direction> mirrored(glm::dvec2 place) const;
  /// Returns the direction to which a facet refracts; `ratio` is that of the indices before and
  /// behind. For a thin wall, whose ratio is 1, it is the mirrored direction on the other side
  /// (KHR_materials_transmission, "Transmission BTDF"). All directions have the same weight, since
  /// light that one facet blocks passes others. Returns none at total reflection.
  [[nodiscard]] std::optional<glm::vec3> refracted(glm::dvec2 place, float ratio) const;

 private:
  [[nodiscard]] glm::vec3 world(glm::vec3 v) const {
    return v.x * right_ + v.y * up_ + v.z * normal_;
  }

  glm::vec3 f0_, f90_;
  glm::vec3 right_, up_, normal_;
  glm::vec3 viewer_;  // direction to the viewer, in this frame
  glm::vec2 alpha_;
};

/// Returns a visible normal of a lobe with this squared roughness along x and y, for a viewer in
/// the unit direction `v`, all in the lobe's frame (Heitz 2018, appendix A).
[[nodiscard]] glm::vec3 visible_normal(glm::vec3 v, glm::vec2 alpha, glm::vec2 place);

/// A tangent frame of any direction (Duff et al. 2017, "Building an Orthonormal Basis, Revisited"),
/// or of a stretched lobe, with its first direction along the stretch.
struct Tangents {
  explicit Tangents(glm::vec3 n);
  Tangents(glm::vec3 n, const LobeStretch& stretch);
  [[nodiscard]] glm::vec3 world(glm::vec3 v) const { return v.x * right + v.y * up + v.z * normal; }
  [[nodiscard]] glm::vec3 local(glm::vec3 v) const {
    return {glm::dot(v, right), glm::dot(v, up), glm::dot(v, normal)};
  }

  glm::vec3 normal, right{}, up{};
};

}  // namespace asos
