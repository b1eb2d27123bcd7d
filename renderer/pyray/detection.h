#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

namespace asos {

/// How it is found out whether a boundary passes through a (sub-)pyray: by its exact square, or by
/// the circular cone that surrounds it, as published (CGF'98 section 3). The cone takes boundaries
/// for near that miss the pyray by up to a fifth of its side (more where it is seen askew): more
/// marginal pyrays, no less accuracy, for samples lie in the square all the same.
enum class Detection { square, cone };

/// The detection test of one root frame's cells.
class Detector {
 public:
  explicit Detector(const Frame& frame, Detection kind = Detection::square);

  /// The smallest square, to rounding, that holds everything that can count as near `cell`.
  [[nodiscard]] Square reach(const Square& cell) const;

  /// Whether a boundary that meets `reach(cell)` counts.
  [[nodiscard]] bool near(const Segment& s, const Square& cell) const;

 private:
  // The right circular cone (pyramid) or cylinder (prism) around a cell: the directions d + e with
  // |e x axis|^2 <= sine2 |d + e|^2 (cylinder: radius2), where d points to the cell's centre.
  struct Cone {
    glm::dvec3 centre;
    glm::dvec3 axis;
    double sine2 = 0.0;
    double radius2 = 0.0;
  };
  [[nodiscard]] Cone around(const Square& cell) const;

  Detection kind_;
  bool parallel_;
  glm::dvec3 a_, b_, c_;
  glm::dvec3 direction_;
};

}  // namespace asos
