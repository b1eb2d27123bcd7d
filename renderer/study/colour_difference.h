#pragma once

#include <glm/glm.hpp>

namespace asos {

/// A colour in CIE 1976 L*a*b*.
struct Lab {
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
};

/// The CIELAB colour of linear sRGB, each channel 0 to 1, seen under its own white (IEC 61966-2-1,
/// D65).
[[nodiscard]] Lab lab_of_linear_srgb(glm::dvec3 linear);

/// CIEDE2000 with kL = kC = kH = 1 (Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference
/// formula: implementation notes, supplementary test data, and mathematical observations"). About 1
/// is what an observer just notices between patches side by side.
[[nodiscard]] double ciede2000(const Lab& first, const Lab& second);

}  // namespace asos
