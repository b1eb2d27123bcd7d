#pragma once

#include "renderer/geometry/ellipse_arc.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/half_space.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// The bounds of a curve's pieces: the pyramid, widened by `margin`, and half-spaces.
struct FlattenBounds {
  double margin = 0.0;
  std::span<const HalfSpace> within;
  double beyond_first = 0.0;  ///< as in SearchBounds
};

/// Replaces the part of an arc that lies in a frame's pyramid by straight segments, in order. Each
/// segment ends where the next begins, bit for bit. The segments lie on both sides of the arc, so
/// that they enclose the same area. No piece's area differs from its arc's by more than
/// `finest_side`^2 / 400, and its distance is at most a 16th of `finest_side`. The arc's points at
/// `breaks` (angles) are exact ends of segments. Reuses its memory; one object per thread.
class Flattener {
 public:
  [[nodiscard]] std::span<const Segment> flatten(const Frame& frame, const EllipseArc& arc,
                                                 std::span<const double> breaks, double finest_side,
                                                 const FlattenBounds& bounds);

 private:
  struct Break {
    double angle;  ///< among `angles_`
    double given;  ///< the angle as given: differs by whole turns
  };
  struct Joint {
    double angle = 0.0;
    FramePoint at;
    glm::dvec2 bulge{0.0};  ///< offset of the arc from the chord to the next joint
    bool fixed = false;
  };

  void find_angles(const Frame& frame, const EllipseArc& arc, std::span<const double> breaks,
                   const FlattenBounds& bounds);
  [[nodiscard]] const Break* break_at(double angle) const;
  [[nodiscard]] FramePoint place(const Frame& frame, const EllipseArc& arc, double angle) const;
  [[nodiscard]] bool inside(const Frame& frame, glm::dvec3 p, const FlattenBounds& bounds) const;
  void emit(const Frame& frame, const EllipseArc& arc, double from, double to, double finest_side);
  void split(const Frame& frame, const EllipseArc& arc, const Joint& from, const Joint& to,
             double finest_side, int depth);
  void settle(bool closed);

  std::vector<double> angles_;
  std::vector<Break> breaks_;
  std::vector<Joint> joints_;
  std::vector<FramePoint> moved_;
  std::vector<Segment> segments_;
};

}  // namespace asos
