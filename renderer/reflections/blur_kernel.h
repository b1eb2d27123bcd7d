#pragma once

#include "renderer/geometry/bounds2.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

namespace asos {

/// The weights of the parts of a blurred reflection's square. Each coordinate's weight is the box
/// of the pyray without blur convolved with the lobe's box: a trapezoid over 0 to 1. The integral
/// is 1.
class BlurKernel {
 public:
  /// `share` is the width of one of the two boxes relative to the whole width, the narrower or the
  /// wider, 0 to 1 each.
  explicit BlurKernel(glm::dvec2 share);

  /// Returns the integral over a region. Exact for straight sides, by Green's theorem: along a side
  /// the integrand is a cubic between the trapezoid's kinks, which two Gauss-Legendre points
  /// integrate exactly.
  [[nodiscard]] double integral(const LeafRegion& region) const;

  /// Returns the rectangle over which a uniform distribution has the kernel's mean and variances
  /// within `part`. For the whole square, its sides are the root of the sum of the two boxes'
  /// squares. Where the kernel is 0 all over `part`, returns `part`.
  [[nodiscard]] Bounds2 uniform_like(const Bounds2& part) const;

  /// Maps a uniformly distributed point of a rectangle to the kernel's distribution within that
  /// rectangle.
  [[nodiscard]] glm::vec2 warped(glm::vec2 p, const Bounds2& part) const;

 private:
  /// The trapezoid of one coordinate: rising up to `ramp`, falling from 1 - `ramp`.
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
