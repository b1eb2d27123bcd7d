#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace asos {

/// The value at one place, with its noise.
struct NoisyValue {
  glm::dvec2 at{0.0};
  glm::dvec3 value{0.0};
  double variance = 1.0;  ///< variance of the noise, in each channel
};

/// A polynomial that fits values over a surface of a block, by least squares weighted by their
/// noise. Its degree is 2 if there are enough values, else 1.
class PolynomialFit {
 public:
  /// Fewest values for a fit of degree 1 and of degree 2. They exceed the number of coefficients,
  /// so that the fit can be checked. `through` returns nothing if the values are too few or lie on
  /// a line.
  static constexpr std::size_t fewest = 5, fewest_bent = 9;
  [[nodiscard]] static std::optional<PolynomialFit> through(std::span<const NoisyValue> values);

  [[nodiscard]] glm::dvec3 at(glm::dvec2 place) const;
  /// Returns the reduced chi-squared of the fit, in the worst channel: squared residuals over the
  /// variance of the noise, per degree of freedom. It is 1 on average where noise is the only
  /// cause.
  [[nodiscard]] double misfit() const { return misfit_; }

 private:
  static constexpr std::size_t most_terms = 6;
  using Terms = std::array<double, most_terms>;
  [[nodiscard]] Terms terms_at(glm::dvec2 place) const;

  std::size_t count_ = 0;  // number of terms
  glm::dvec2 middle_{0.0};
  double scale_ = 1.0;
  std::array<glm::dvec3, most_terms> factors_{};
  double misfit_ = 0.0;
};

}  // namespace asos
