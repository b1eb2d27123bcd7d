#pragma once

#include "renderer/shading/gradient.h"

#include <glm/glm.hpp>

namespace asos {

/// The part of a sky's radiance that varies with the azimuth. It is grey, has mean 0, and consists
/// of the sectoral spherical harmonics (m = +-l) of degrees 1 and 2. Azimuths are about +Y from +Z,
/// in degrees. All means are closed forms. Immutable.
class AzimuthVariation {
 public:
  /// Maxima and their azimuths. Degree 1 is `one` there and -`one` on the opposite side. Degree 2
  /// is `two` at both ends of an axis and -`two` across it.
  struct Amounts {
    double one = 0.0, one_deg = 0.0;
    double two = 0.0, two_deg = 0.0;
  };

  AzimuthVariation() = default;
  explicit AzimuthVariation(const Amounts& amounts);

  [[nodiscard]] bool none() const { return none_; }

  /// Returns the mean over a small patch around a unit direction, with edges perpendicular to it.
  [[nodiscard]] double mean(glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const {
    return linear(direction) + square(direction) + (square(right) + square(down)) / 12.0;
  }
  /// As Gradient::around.
  [[nodiscard]] double around(glm::dvec3 direction, double width) const;
  [[nodiscard]] double irradiance_over_pi(glm::dvec3 normal) const {
    // Degrees 1 and 2 of the clamped cosine (Ramamoorthi and Hanrahan 2001).
    return 2.0 / 3.0 * linear(normal) + 0.25 * square(normal);
  }

 private:
  [[nodiscard]] double linear(glm::dvec3 d) const { return glm::dot(one_, d); }
  [[nodiscard]] double square(glm::dvec3 d) const {
    const double along = glm::dot(along_, d), across = glm::dot(across_, d);
    return two_ * (along * along - across * across);
  }

  bool none_ = true;
  glm::dvec3 one_{0.0};
  glm::dvec3 along_{0.0}, across_{0.0};
  double two_ = 0.0;
};

}  // namespace asos
