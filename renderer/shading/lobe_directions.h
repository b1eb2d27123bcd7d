#pragma once

#include "renderer/shading/brdf.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// Directions in which a GGX lobe looks for its viewer, to where it mirrors or refracts: by visible
/// normals (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"). Keeps what does not
/// depend on the place.
class LobeDirections {
 public:
  /// Squared roughness, at least, along both directions.
  static constexpr float least_alpha = 1e-4f;

  /// `spread`: what bumps that are smaller than a sample add to the squares of the lobe's squared
  /// roughness. All directions are unit.
  LobeDirections(const ViewedMaterial& material, float spread, glm::vec3 normal,
                 glm::vec3 to_viewer);

  struct Direction {
    glm::vec3 unit{0.0f};
    glm::vec3 weight{0.0f};  ///< of the radiance from there in that towards the viewer
  };
  /// That of a place in the unit square: the mean over places of radiance times weight is the
  /// integral of radiance, lobe, Fresnel's term and cosine over the hemisphere of the normal. None:
  /// below it.
  [[nodiscard]] std::optional<Direction> mirrored(glm::dvec2 place) const;
  /// Where a facet refracts to, by the ratio of the indices before and behind it; of a thin wall,
  /// whose ratio is 1, the mirrored direction on its other side (KHR_materials_transmission,
  /// "Transmission BTDF"). All weigh the same: what facets keep from each other goes through
  /// others. None where all is reflected.
  [[nodiscard]] std::optional<glm::vec3> refracted(glm::dvec2 place, float ratio) const;

 private:
  [[nodiscard]] glm::vec3 world(glm::vec3 v) const {
    return v.x * right_ + v.y * up_ + v.z * normal_;
  }

  glm::vec3 f0_, f90_;
  glm::vec3 right_, up_, normal_;
  glm::vec3 viewer_;  // in this frame
  glm::vec2 alpha_;
};

/// A normal of a lobe of this squared roughness along x and y, as a viewer in the unit direction
/// `v` sees it, all in the lobe's frame (Heitz 2018, appendix A).
[[nodiscard]] glm::vec3 visible_normal(glm::vec3 v, glm::vec2 alpha, glm::vec2 place);

/// A tangent frame of any direction (Duff et al. 2017, "Building an Orthonormal Basis, Revisited"),
/// or of a stretched lobe, whose first direction is along the stretch.
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
