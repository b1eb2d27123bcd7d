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

// The extent that a sample stands for: a square of the picture, and the patch of surface that it
// shows.

namespace asos {

/// One pixel's steps in a picture, as ray differentials need them (Igehy 1999): of a ray's target
/// one unit ahead of the eye, or of its origin where the rays are parallel.
struct PixelSpacing {
  bool perspective = true;
  glm::vec3 forward{0, 0, -1};  ///< unit
  glm::vec3 right{0.0f};        ///< world units a pixel
  glm::vec3 down{0.0f};
  float start = 0.0f;  ///< of the rays from the eye: View::start

  [[nodiscard]] static PixelSpacing of(const View& view);

  /// From where the rays' lines meet to what is `t` along one of them; infinite where they do not.
  [[nodiscard]] float distance(float t) const {
    return perspective ? start + t : std::numeric_limits<float>::infinity();
  }
};

/// The shape of the part of the picture that a sample stands for, beside a square of the same area
/// around it: a parallelogram with the part's centroid and covariance. In sides of that square.
struct PartShape {
  glm::vec2 offset{0.0f};  ///< of the centroid from the sample
  glm::vec2 right{1.0f, 0.0f};
  glm::vec2 down{0.0f, 1.0f};
};

/// One of several such parts that make up a whole.
struct SharedShape {
  PartShape shape;     ///< in sides of the square that has the whole's area
  float share = 1.0f;  ///< of the whole's area
};

/// The square itself. Copied from here, it takes no waiting for what was just written.
inline constexpr PartShape square_part{};

/// A parallelogram on a surface by its edges, in world units. A default one is a point.
struct Patch {
  glm::vec3 right{0.0f};
  glm::vec3 down{0.0f};
};

/// Where rays are this steep or steeper a patch is exact, to first order; below it is no longer
/// than it would be there, 64 times its width. An edge-on surface would make it infinite.
inline constexpr float steepest_patch = 1.0f / 64.0f;

/// The patch of the plane with unit `normal` that a square of `side` pixels shows around a ray of
/// unit `direction` that hits it at `distance` from where the ray starts. Not finite where the
/// input is not.
[[nodiscard]] inline Patch patch_on_plane(const PixelSpacing& spacing, glm::vec3 direction,
                                          float distance, glm::vec3 normal, float side) {
  // A target T + x R gives the point O + s(x) (T + x R) of the plane, so that, at x = 0, the point
  // moves by s (R - T (n.R) / (n.T)) a pixel. Parallel rays: the same with s = 1.
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

/// A patch in a triangle's own coordinates: how far (b1, b2) of its hit go along the patch's edges.
struct Footprint {
  glm::vec2 right{0.0f};
  glm::vec2 down{0.0f};
  glm::vec2 offset{0.0f};  ///< of its middle from the hit
  float side =
      1.0f;  ///< of the square that shows it, in pixels: how much what is seen there counts
  float colours = 1.0f;  ///< times as wide as colours are averaged over

  [[nodiscard]] bool point() const { return right == glm::vec2(0.0f) && down == glm::vec2(0.0f); }
};

/// The footprint of the patch on the plane with the edges e1 and e2. A point for a patch that is
/// not finite and for edges that span no area.
[[nodiscard]] inline Footprint footprint_between(glm::vec3 e1, glm::vec3 e2, const Patch& patch) {
  // The duals of the edges in the triangle's plane, by Gram's matrix.
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

/// What colours are averaged over.
[[nodiscard]] inline Footprint of_colours(const Footprint& f) {
  return {f.colours * f.right, f.colours * f.down, f.offset, f.colours * f.side};
}

/// A square's footprint, shown by a part of another shape instead.
[[nodiscard]] inline Footprint shaped(const Footprint& square, const PartShape& part) {
  const auto along = [&](glm::vec2 p) { return p.x * square.right + p.y * square.down; };
  return {along(part.right), along(part.down), along(part.offset), square.side, square.colours};
}

/// The same of a patch.
[[nodiscard]] inline Patch shaped(const Patch& square, const PartShape& part) {
  const auto along = [&](glm::vec2 p) { return p.x * square.right + p.y * square.down; };
  return {along(part.right), along(part.down)};
}

/// How far what is linear over a triangle goes along the footprint's edges, from its values at the
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
