#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

// Surfaces that light goes straight through, one behind the other.

namespace asos {

/// A surface of those that a ray shows one through the other.
struct SeenLayer {
  Hit hit;
  float opacity = 1.0f;  ///< mean of what it hides over all that the ray stands for
  bool varies = false;   ///< a texture tells how much: what it hides in part may be all of it here
};

/// By how much what layers let through together may be off, 0 to 1, where each is known by its
/// mean: the sum over the layers of the standard deviation of what those before let through times
/// the layer's own, the most that their covariance is. 0: no two of them vary.
[[nodiscard]] float unevenness_of(std::span<const SeenLayer> layers);

/// The share of a layer behind others below which no display shows it, even at +8 stops.
inline constexpr float invisible_share = 1.0f / (256.0f * 256.0f);
/// The same behind a stack of `deep_stack` surfaces and more, whose every surface takes time: a
/// quarter of an 8-bit step.
inline constexpr float invisible_in_stack = 1.0f / 1024.0f;
inline constexpr int deep_stack = 64;

/// Whether that share is invisible behind so many surfaces.
[[nodiscard]] constexpr bool invisible(float share, int layers) {
  return share < (layers < deep_stack ? invisible_share : invisible_in_stack);
}

/// Counts the surfaces along a ray that show something, up to `most`, after which the rest is
/// dropped. Clear ones are passed without being counted, but for so many that only an endless stack
/// has them.
class LayerCount {
 public:
  static constexpr int most = 1024;

  [[nodiscard]] int layers() const { return layers_; }
  [[nodiscard]] bool full() const { return layers_ >= most || passed_ >= most_passed; }
  void add_layer() { ++layers_; }
  void pass_clear() { ++passed_; }

 private:
  static constexpr int most_passed = 1 << 16;
  int layers_ = 0;
  int passed_ = 0;
};

/// Where the ray goes on behind a surface it has met: beyond the error of the hit's distance.
[[nodiscard]] inline float behind(const Ray& ray, const SurfacePoint& point, float t) {
  const float length = glm::length(ray.direction);
  const glm::vec3 d = ray.direction / length;
  const float across = std::abs(glm::dot(point.geometric_normal, d));
  // The surface's own error along its normal, seen along the ray; at most 64 times that for rays
  // that graze it. A triangle met twice all the same is noticed by its index.
  const glm::vec3 moved =
      point.position + clear_height(point) * point.geometric_normal - point.position;
  const float error = glm::length(moved) / (std::max(across, 1.0f / 64.0f) * length);
  return std::max(std::nextafter(t, std::numeric_limits<float>::infinity()), t + error);
}

/// The surfaces along a ray, one behind the other. Those in one place follow each other from front
/// to back, and none is met twice.
class SurfaceWalk {
 public:
  /// Begins at a hit of `ray`, the front one of its place.
  SurfaceWalk(const RayScene& rays, const Ray& ray, const Hit& first, Culling faces)
      : rays_(&rays), faces_(faces), ray_(ray), hit_(first) {}

  [[nodiscard]] const Ray& ray() const { return ray_; }
  [[nodiscard]] const Hit& hit() const { return hit_; }
  /// Goes on behind the hit, which is at `point`.
  void go_on(const SurfacePoint& point);

 private:
  const RayScene* rays_;
  Culling faces_;
  Ray ray_;
  Hit hit_;
  std::vector<Hit> place_;  ///< what lies in the hit's place; empty: the hit alone
  std::size_t next_ = 0;    ///< of these
};

}  // namespace asos
