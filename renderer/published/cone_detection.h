#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/subdivision_variant.h"

#include <glm/glm.hpp>

namespace asos {

/// Detects the boundaries that meet the circular cone around a cell, or a cylinder in a parallel
/// frame (CGF'98 section 3).
class ConeDetection final : public DetectionTest {
 public:
  explicit ConeDetection(const Frame& frame);

  [[nodiscard]] Square reach(const Square& cell) const override;
  [[nodiscard]] bool near(const Segment& s, const Square& cell) const override;

 private:
  // The right circular cone (pyramid) or cylinder (prism) around a cell. It contains the directions
  // d + e with |e x axis|^2 <= sine2 |d + e|^2 (cylinder: radius2), where d points to the cell's
  // centre.
  struct Cone {
    glm::dvec3 centre;
    glm::dvec3 axis;
    double sine2 = 0.0;
    double radius2 = 0.0;
  };
  [[nodiscard]] Cone around(const Square& cell) const;

  bool parallel_;
  glm::dvec3 a_, b_, c_;
  glm::dvec3 direction_;
};

}  // namespace asos
