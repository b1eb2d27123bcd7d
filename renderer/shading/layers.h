#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/passed_layers.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

// Transparent surfaces behind each other that do not deflect light.

namespace asos {

/// One of the surfaces along a ray through transparent surfaces.
struct SurfaceLayer {
  Hit hit;
  float opacity = 1.0f;  ///< mean opacity over the extent of the ray
  /// A texture varies the opacity: it may be anything from 0 to 1 at a point.
  bool varies = false;
};

/// A surface along a ray, with the part of the ray that it covers.
struct SurfaceCover {
  Hit hit;
  float share = 1.0f;
};

/// The surfaces along a ray, in depth order, as far as they are visible.
struct CoveredRay {
  std::vector<SurfaceCover> surfaces;
  float coverage = 0.0f;  ///< of all together
};

/// Returns a bound on the error of the transmittance of several layers, 0 to 1, if it is taken as
/// the product of their means. It is the sum over the layers of the standard deviation of the
/// transmittance before a layer times the layer's own; their covariance is at most that. 0: no two
/// of them vary.
[[nodiscard]] float unevenness_of(std::span<const SurfaceLayer> layers);

/// The smallest visible contribution of a layer behind others, even at +8 stops.
inline constexpr float invisible_share = 1.0f / (256.0f * 256.0f);
/// The limit for stacks of `deep_stack` and more surfaces, because each of them takes time. It is a
/// quarter of an 8-bit step.
inline constexpr float invisible_in_stack = 1.0f / 1024.0f;
inline constexpr int deep_stack = 64;

/// Returns whether a contribution behind that many layers is invisible.
[[nodiscard]] constexpr bool invisible(float share, int layers) {
  return share < (layers < deep_stack ? invisible_share : invisible_in_stack);
}

/// Returns where the ray continues behind a surface, beyond the error of the hit's distance.
[[nodiscard]] inline float behind(const Ray& ray, const SurfacePoint& point, float t) {
  const float length = glm::length(ray.direction);
  const glm::vec3 d = ray.direction / length;
  const float across = std::abs(glm::dot(point.geometric_normal, d));
  // The surface's own error along its normal, projected to the ray; at most 64 times that for
  // grazing rays. A triangle that is hit twice nevertheless is recognized by its index.
  const glm::vec3 moved =
      point.position + clear_height(point) * point.geometric_normal - point.position;
  const float error = glm::length(moved) / (std::max(across, 1.0f / 64.0f) * length);
  return std::max(std::nextafter(t, std::numeric_limits<float>::infinity()), t + error);
}

/// Visits the surfaces along a ray in depth order. Coplanar surfaces follow each other from front
/// to back, and none is visited twice.
class SurfaceWalk {
 public:
  /// Begins at a hit of `ray`, the front one of several coplanar ones.
  SurfaceWalk(const RayScene& rays, const Ray& ray, const Hit& first, Culling faces)
      : rays_(&rays), faces_(faces), ray_(ray), hit_(first) {}

  [[nodiscard]] const Ray& ray() const { return ray_; }
  [[nodiscard]] const Hit& hit() const { return hit_; }
  /// Continues behind the hit, which is at `point`.
  void go_on(const SurfacePoint& point);

 private:
  const RayScene* rays_;
  Culling faces_;
  Ray ray_;
  Hit hit_;
  std::vector<Hit> place_;  ///< surfaces coplanar with the hit; empty: only the hit
  std::size_t next_ = 0;    ///< index of the next one in `place_`
};

/// Returns the nearest hit of a surface that is there: blended surfaces of opacity 0 are passed.
[[nodiscard]] Hit closest_visible(const World& world, const RenderFeatures& render_features,
                                  const RayScene& rays, const Ray& ray, Culling faces);

}  // namespace asos
