#include "renderer/shading/azimuth_variation.h"

#include <cmath>
#include <numbers>

namespace asos {
namespace {

glm::dvec3 horizontal(double azimuth_deg) {
  const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
  return {std::sin(azimuth), 0.0, std::cos(azimuth)};
}

}  // namespace

AzimuthVariation::AzimuthVariation(const Amounts& amounts)
    : none_(amounts.one == 0.0 && amounts.two == 0.0),
      one_(amounts.one * horizontal(amounts.one_deg)),
      along_(horizontal(amounts.two_deg)),
      across_(horizontal(amounts.two_deg + 90.0)),
      two_(amounts.two) {}

double AzimuthVariation::around(glm::dvec3 direction, double width) const {
  // The disk's second moments across the direction are equal, and the form square() has trace 0.
  const DiskMoments disk = DiskMoments::of(static_cast<float>(width));
  const auto along = static_cast<double>(disk.along), squared = static_cast<double>(disk.squared);
  return along * linear(direction) + (1.5 * squared - 0.5) * square(direction);
}

}  // namespace asos
