#pragma once

#include <glm/glm.hpp>

namespace asos {

/// A colour in CIE 1976 L*a*b*.
struct Lab {
  double l = 0.0;
  double a = 0.0;
  double b = 0.0;
};

/// Returns the CIELAB colour of linear sRGB, each channel 0 to 1, relative to its own white (IEC
/// 61966-2-1, D65).
[[nodiscard]] Lab lab_of_linear_srgb(glm::dvec3 linear);

/// Returns CIEDE2000 with kL = kC = kH = 1 (Sharma, Wu and Dalal 2005, "The CIEDE2000
/// color-difference formula: implementation notes, supplementary test data, and mathematical
/// observations"). A value of about 1 is just noticeable between adjacent patches.
[[nodiscard]] double ciede2000(const Lab& first, const Lab& second);

}  // namespace asos
