#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/geometry/view.h"
#include "renderer/world/hit_plane.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

// The extent of a sample: a square of the picture, and the patch of surface that it covers.

namespace asos {

/// One pixel's steps in a picture, for ray differentials (Igehy 1999). They move a ray's target one
/// unit ahead of the eye, or its origin where the rays are parallel.
struct PixelSpacing {
  bool perspective = true;
  glm::vec3 forward{0, 0, -1};  ///< unit
  glm::vec3 right{0.0f};        ///< world units per pixel
  glm::vec3 down{0.0f};
  float start = 0.0f;  ///< start of the rays, measured from the eye: View::start

  [[nodiscard]] static PixelSpacing of(const View& view);

  /// Returns the distance from the common point of the rays' lines to the point at `t` along a ray;
  /// infinite for parallel rays.
  [[nodiscard]] float distance(float t) const {
    return perspective ? start + t : std::numeric_limits<float>::infinity();
  }
};

/// The shape of the part of the picture that a sample represents, relative to a square of the same
/// area around it. It is a parallelogram with the part's centroid and covariance, in sides of that
/// square.
struct FootprintShape {
  glm::vec2 offset{0.0f};  ///< from the sample to the centroid
  glm::vec2 right{1.0f, 0.0f};
  glm::vec2 down{0.0f, 1.0f};
};

/// One of several parts that make up a whole.
struct WeightedShape {
  FootprintShape shape;  ///< in sides of the square with the whole's area
  float share = 1.0f;    ///< fraction of the whole's area
};

/// The square itself. Copying this constant avoids a stall on values that were just written.
inline constexpr FootprintShape square_part{};

/// A parallelogram on a surface, by its edges, in world units. The default is a point.
struct Patch {
  glm::vec3 right{0.0f};
  glm::vec3 down{0.0f};
};

/// Limits the length of patches. Where rays are at least this steep, a patch is exact to first
/// order. For flatter rays it is as long as at this slope, 64 times its width, since an edge-on
/// surface would make it infinite.
inline constexpr float steepest_patch = 1.0f / 64.0f;

/// Returns the patch of a plane with unit `normal` that a square of `side` pixels covers around a
/// ray of unit `direction` that hits it at `distance`. Not finite where the input is not.
[[nodiscard]] inline Patch patch_on_plane(const PixelSpacing& spacing, glm::vec3 direction,
                                          float distance, glm::vec3 normal, float side) {
  // A target T + x R corresponds to the point O + s(x) (T + x R) of the plane. At x = 0 the point
  // moves by s (R - T (n.R) / (n.T)) per pixel. For parallel rays s is 1.
  const float scale = side * (spacing.perspective ? (spacing.start + distance) *
                                                        glm::dot(direction, spacing.forward)
                                                  : 1.0f);
  const float cosine = glm::dot(normal, direction);
  const float per_cosine = 1.0f / std::copysign(std::max(std::abs(cosine), steepest_patch), cosine);
  const auto moved = [&](glm::vec3 step) {
    return scale * (step - (glm::dot(normal, step) * per_cosine) * direction);
  };
  return {moved(spacing.right), moved(spacing.down)};
}

/// A patch in a triangle's own coordinates: the change of (b1, b2) along the patch's edges.
struct Footprint {
  glm::vec2 right{0.0f};
  glm::vec2 down{0.0f};
  glm::vec2 offset{0.0f};  ///< from the hit to the footprint's centre
  /// Side of the square of the picture that the footprint covers, in pixels. It determines how
  /// finely textures are averaged.
  float side = 1.0f;
  float colours = 1.0f;  ///< factor of the width over which colours are averaged

  [[nodiscard]] bool point() const { return right == glm::vec2(0.0f) && down == glm::vec2(0.0f); }
};

/// Returns the footprint of a patch on the plane with the edges e1 and e2. It is a point for a
/// patch that is not finite, and for edges that span no area.
[[nodiscard]] inline Footprint footprint_between(glm::vec3 e1, glm::vec3 e2, const Patch& patch) {
  // The dual basis of the edges in the triangle's plane, by Gram's matrix.
  const float g11 = glm::dot(e1, e1);
  const float g12 = glm::dot(e1, e2);
  const float g22 = glm::dot(e2, e2);
  const float det = g11 * g22 - g12 * g12;
  if (!(det > 0.0f)) return {};
  const float per_det = 1.0f / det;
  const auto along = [&](glm::vec3 p) {
    const float p1 = glm::dot(e1, p);
    const float p2 = glm::dot(e2, p);
    return glm::vec2(g22 * p1 - g12 * p2, g11 * p2 - g12 * p1) * per_det;
  };
  Footprint f;
  f.right = along(patch.right);
  f.down = along(patch.down);
  return std::isfinite(f.right.x + f.right.y + f.down.x + f.down.y) ? f : Footprint{};
}

/// The footprint of a hit on a triangle or on a face of an analytic shape.
[[nodiscard]] inline Footprint footprint_on(const World& world, const Hit& hit,
                                            const Patch& patch) {
  if (world.is_face(hit.triangle)) {
    const HitPlane plane = hit_plane(world, hit);
    return footprint_between(glm::vec3(plane.edge1), glm::vec3(plane.edge2), patch);
  }
  const glm::uvec3 v = world.triangles[hit.triangle];
  const glm::vec3 p0 = world.positions[v.x];
  return footprint_between(world.positions[v.y] - p0, world.positions[v.z] - p0, patch);
}

/// Returns the footprint over which colours are averaged.
[[nodiscard]] inline Footprint of_colours(const Footprint& f) {
  return {f.colours * f.right, f.colours * f.down, f.offset, f.colours * f.side};
}

/// Returns the footprint of a part of the square with another shape.
[[nodiscard]] inline Footprint shaped(const Footprint& square, const FootprintShape& part) {
  const auto along = [&](glm::vec2 p) { return p.x * square.right + p.y * square.down; };
  return {along(part.right), along(part.down), along(part.offset), square.side, square.colours};
}

/// Returns the patch of a part of the square with another shape.
[[nodiscard]] inline Patch shaped(const Patch& square, const FootprintShape& part) {
  const auto along = [&](glm::vec2 p) { return p.x * square.right + p.y * square.down; };
  return {along(part.right), along(part.down)};
}

/// Changes of a linear function over a triangle along the footprint's edges, from its values at the
/// corners.
template <typename T>
struct Steps {
  T right;
  T down;

  Steps(const Footprint& f, const T& at_0, const T& at_1, const T& at_2)
      : right(f.right.x * (at_1 - at_0) + f.right.y * (at_2 - at_0)),
        down(f.down.x * (at_1 - at_0) + f.down.y * (at_2 - at_0)) {}
};

}  // namespace asos
