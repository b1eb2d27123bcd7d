#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/square.h"
#include "renderer/settings/choices.h"

#include <glm/glm.hpp>

namespace asos {

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
