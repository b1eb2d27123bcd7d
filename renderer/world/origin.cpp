#include "renderer/world/origin.h"

#include <algorithm>

namespace asos {
namespace {

// Largest rounding error of a part's corners, relative to its size, that keeps the origin at the
// centre.
constexpr double let_pass = 1.0 / 1024.0;

/// Returns the rounding error of a part's corners in single precision, relative to its size.
double loss(const PlacedBox& part, glm::dvec3 origin) {
  constexpr double half_ulp = 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const double size = part.extent();
  return size > 0.0 ? half_ulp * glm::distance(part.middle(), origin) / size : 0.0;
}

const PlacedBox& worst_of(const std::vector<PlacedBox>& parts, glm::dvec3 origin) {
  return *std::max_element(parts.begin(), parts.end(), [&](const PlacedBox& a, const PlacedBox& b) {
    return loss(a, origin) < loss(b, origin);
  });
}

}  // namespace

double PlacedBox::extent() const {
  return std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
}

glm::dvec3 choose_origin(const std::vector<PlacedBox>& parts, glm::dvec3 middle) {
  const PlacedBox& worst = worst_of(parts, middle);
  if (!(loss(worst, middle) > let_pass)) return middle;
  const glm::dvec3 there = worst.middle();
  return loss(worst_of(parts, there), there) < 0.25 * loss(worst, middle) ? there : middle;
}

}  // namespace asos
