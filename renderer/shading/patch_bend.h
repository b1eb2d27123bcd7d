#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/normal_spread.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/viewed_point.h"

#include <glm/glm.hpp>

#include <array>

namespace asos {

/// How the patch that a point stands for is bent, to look at more of it than its middle: at Gauss
/// and Legendre's two points along each edge, whose mean is exact for what is cubic across the
/// patch, as the middle is for what is linear.
struct PatchBend {
  NormalSpread turn;             ///< of the shading normal along the edges
  glm::vec2 stretch_turn{0.0f};  ///< of the lobe's stretch about the normal, in radians
  bool rounded = false;          ///< the surface itself bends as its normals do
  float negligible = 0.0f;       ///< radiance by which the middle may differ from the mean

  /// That of the patch of `view`, where `hit` is its middle.
  [[nodiscard]] static PatchBend at(const World& world, const Hit& hit, const ViewedPoint& view,
                                    const ViewedMaterial& material, float negligible);

  /// The patch's squared width, in those of a highlight, up to which so few points tell its mean
  /// better than a lobe that is widened.
  static constexpr float most_bent = 3.0f;

  /// About by which share of it the middle's radiance by a light may differ from the mean: by the
  /// second derivative of the lobe that shows `highlight`; infinite where the patch is wider than
  /// most_bent.
  [[nodiscard]] float error_of_middle(const ViewedPoint& view, const ViewedMaterial& material,
                                      const PreparedLight& light, const Highlight& highlight) const;

  /// A point of the patch.
  struct Point {
    SurfacePoint surface;
    glm::vec3 to_viewer;  ///< unit
    ViewedMaterial material;
  };
  /// Those whose mean counts.
  [[nodiscard]] std::array<Point, 4> points(const ViewedPoint& view,
                                            const ViewedMaterial& material) const;

 private:
  /// From the middle, to second order.
  struct Step {
    glm::vec3 place;
    glm::vec3 normal;
  };
  [[nodiscard]] Step step(const ViewedPoint& view, float u, float v) const;
};

}  // namespace asos
