#include "renderer/asos/polynomial_fit.h"

#include "renderer/geometry/largest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

constexpr std::size_t plane_terms = 3;

/// Solves a symmetric system by Gauss's elimination. Returns false if the matrix is singular.
template <std::size_t size>
bool solve(std::array<std::array<double, size>, size>& a, std::array<glm::dvec3, size>& b,
           std::size_t count) {
  // Smallest pivot, relative to the row's diagonal element before elimination.
  constexpr double least_pivot = 1e-6;
  std::array<double, size> began{};
  for (std::size_t i = 0; i < count; ++i) began[i] = a[i][i];
  for (std::size_t k = 0; k < count; ++k) {
    if (!(a[k][k] > least_pivot * began[k])) return false;
    for (std::size_t i = k + 1; i < count; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < count; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t j = k + 1; j < count; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return true;
}

}  // namespace

PolynomialFit::Terms PolynomialFit::terms_at(glm::dvec2 place) const {
  const glm::dvec2 p = (place - middle_) / scale_;
  return {1.0, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y};
}

std::optional<PolynomialFit> PolynomialFit::through(std::span<const NoisyValue> values) {
  if (values.size() < fewest) return std::nullopt;
  PolynomialFit fit;
  fit.count_ = values.size() < fewest_bent ? plane_terms : most_terms;
  // Centre and scale the places, for numerical stability.
  for (const NoisyValue& known : values)
    fit.middle_ += known.at / static_cast<double>(values.size());
  double size = 0.0;
  for (const NoisyValue& known : values) size = std::max(size, glm::length(known.at - fit.middle_));
  if (!(size > 0.0)) return std::nullopt;
  fit.scale_ = size;

  // Add up the normal equations.
  std::array<std::array<double, most_terms>, most_terms> products{};
  for (const NoisyValue& known : values) {
    const Terms terms = fit.terms_at(known.at);
    for (std::size_t i = 0; i < fit.count_; ++i) {
      for (std::size_t j = 0; j < fit.count_; ++j)
        products[i][j] += terms[i] * terms[j] / known.variance;
      fit.factors_[i] += terms[i] / known.variance * known.value;
    }
  }
  if (!solve(products, fit.factors_, fit.count_)) return std::nullopt;

  glm::dvec3 off(0.0);
  for (const NoisyValue& known : values) {
    const glm::dvec3 by = known.value - fit.at(known.at);
    off += by * by / known.variance;
  }
  fit.misfit_ = largest(off) / static_cast<double>(values.size() - fit.count_);
  return fit;
}

glm::dvec3 PolynomialFit::at(glm::dvec2 place) const {
  const Terms terms = terms_at(place);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < count_; ++i) sum += terms[i] * factors_[i];
  return sum;
}

}  // namespace asos
