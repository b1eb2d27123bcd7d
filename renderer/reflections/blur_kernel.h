#pragma once

#include "renderer/geometry/bounds2.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

namespace asos {

/// The weights of the parts of a blurred reflection's square: each coordinate's weight is a box as
/// wide as the pyray would be without blur, convolved with the lobe's box, so a trapezoid over 0 to
/// 1, and all of it together is 1.
class BlurKernel {
 public:
  /// The share of the whole width that is the narrower of the two boxes, or the wider: 0 to 1 each.
  explicit BlurKernel(glm::dvec2 share);

  /// The integral over a region: exact for straight sides (Green's theorem; along a side the
  /// integrand is a cubic between the trapezoid's kinks, which two points of Gauss and Legendre
  /// integrate exactly).
  [[nodiscard]] double integral(const LeafRegion& region) const;

  /// The rectangle over which a uniform distribution has the mean and the variances that the kernel
  /// has within another one: where that is all of the square, sides of the root of the sum of the
  /// two boxes' squares. Where the kernel is 0 all over it, the same rectangle.
  [[nodiscard]] Bounds2 uniform_like(const Bounds2& part) const;

  /// Where a point that is uniform in a rectangle would be if it were distributed as the kernel is
  /// within that rectangle.
  [[nodiscard]] glm::vec2 warped(glm::vec2 p, const Bounds2& part) const;

 private:
  /// One coordinate's trapezoid: rising up to `ramp`, falling from 1 - `ramp`.
  struct Trapezoid {
    double ramp = 0.0;
    double height = 1.0;

    explicit Trapezoid(double share);
    [[nodiscard]] double at(double x) const;
    [[nodiscard]] double up_to(double x) const;    // integral from 0
    [[nodiscard]] double where(double sum) const;  // inverse of up_to
    [[nodiscard]] glm::dvec2 uniform_like(double lo, double hi) const;
  };
  [[nodiscard]] double along(glm::dvec2 from, glm::dvec2 to) const;

  Trapezoid u_, v_;
};

}  // namespace asos
