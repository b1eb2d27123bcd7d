#pragma once

#include "renderer/geometry/half_space.h"

#include <glm/glm.hpp>

#include <cmath>
#include <optional>

namespace asos {

/// A point of a frame's square with its nearness: u and v run from 0 to 1 across the pyray;
/// the nearness is larger for nearer points and linear along straight lines and across planes (1 /
/// W for an apex, -W for an apex at infinity).
struct FramePoint {
  double u = 0.0;
  double v = 0.0;
  double nearness = 0.0;
};

/// The projective frame of a root pyray (design section 2): takes a world point p to (U, V, W) with
/// p - apex = U a + V b + W c, so that the pyramid is 0 <= U/W, V/W <= 1, W > 0. For an apex at
/// infinity ("parallel") the map is affine and the pyray is the prism 0 <= U, V <= 1.
/// Distances are taken from the apex before anything is multiplied; double precision throughout.
class Frame {
 public:
  /// Pyramid from `apex` through the parallelogram with corner apex + c and edges a, b. The three
  /// vectors must be linearly independent.
  static Frame pyramid(glm::dvec3 apex, glm::dvec3 c, glm::dvec3 a, glm::dvec3 b);
  /// Prism along `direction` (unit) over the parallelogram with corner `corner` and edges a, b.
  static Frame prism(glm::dvec3 corner, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b);

  [[nodiscard]] bool parallel() const { return parallel_; }
  /// Returns a pyramid's apex, or a point of a prism's base.
  [[nodiscard]] glm::dvec3 apex() const { return apex_; }
  /// Returns the unit direction of a prism's rays; for a pyramid, the direction through its centre.
  [[nodiscard]] glm::dvec3 direction() const { return direction_; }

  /// Returns (U, V, W) of a world point.
  [[nodiscard]] glm::dvec3 homogeneous(glm::dvec3 p) const {
    const glm::dvec3 d = p - apex_;
    return {glm::dot(row_u_, d), glm::dot(row_v_, d), glm::dot(row_w_, d)};
  }
  /// Projects a homogeneous point with W > 0 to the square.
  [[nodiscard]] FramePoint project(glm::dvec3 h) const {
    if (parallel_) return {h.x, h.y, -h.z};
    const double q = 1.0 / h.z;
    return {h.x * q, h.y * q, q};
  }
  /// Returns the world point at (u, v) with this nearness.
  [[nodiscard]] glm::dvec3 world(FramePoint p) const;

  /// Returns where the line through (u, v) meets a plane, not behind the apex; nothing if it does
  /// not.
  [[nodiscard]] std::optional<glm::dvec3> on_plane(glm::dvec2 uv, const HalfSpace& plane) const;

  [[nodiscard]] glm::dvec3 row_u() const { return row_u_; }
  [[nodiscard]] glm::dvec3 row_v() const { return row_v_; }
  [[nodiscard]] glm::dvec3 row_w() const { return row_w_; }
  /// Returns an edge of the base: the pyray at W = 1 has the size |a| x |b|.
  [[nodiscard]] glm::dvec3 base_u() const { return a_; }
  [[nodiscard]] glm::dvec3 base_v() const { return b_; }
  [[nodiscard]] glm::dvec3 base_corner() const { return c_; }

 private:
  Frame(bool parallel, glm::dvec3 apex, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b,
        glm::dvec3 c);

  bool parallel_;
  glm::dvec3 apex_;
  glm::dvec3 direction_;
  glm::dvec3 a_, b_, c_;              // columns
  glm::dvec3 row_u_, row_v_, row_w_;  // rows of the inverse of [a b c]
};

/// Computes where the lines through the points of a frame's square meet a plane, for many points.
class PlaneCrossings {
 public:
  PlaneCrossings(const Frame& frame, const HalfSpace& plane)
      : parallel_(frame.parallel()),
        apex_(frame.apex()),
        along_(parallel_ ? frame.direction() : frame.base_corner()),
        a_(frame.base_u()),
        b_(frame.base_v()),
        height_(plane.height(apex_)),
        rise_(glm::dot(plane.normal, along_)),
        rise_u_(glm::dot(plane.normal, a_)),
        rise_v_(glm::dot(plane.normal, b_)) {}

  /// Returns where the line through (u, v) meets the plane, not behind the apex; nothing if it does
  /// not.
  [[nodiscard]] std::optional<glm::dvec3> at(glm::dvec2 uv) const {
    const glm::dvec3 across = uv.x * a_ + uv.y * b_;
    const double rise = uv.x * rise_u_ + uv.y * rise_v_;
    const double t = parallel_ ? -(height_ + rise) / rise_ : -height_ / (rise_ + rise);
    if (!std::isfinite(t) || (!parallel_ && t <= 0.0)) return std::nullopt;
    return parallel_ ? apex_ + across + t * along_ : apex_ + t * (across + along_);
  }

 private:
  bool parallel_;
  glm::dvec3 apex_, along_, a_, b_;
  double height_;                  // of the apex above the plane
  double rise_, rise_u_, rise_v_;  // along the normal, by c and by the edges
};

}  // namespace asos
