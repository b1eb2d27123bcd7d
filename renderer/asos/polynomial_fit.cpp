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
  PolynomialFit course;
  course.count_ = values.size() < fewest_bent ? plane_terms : most_terms;
  // Centre and scale the places, for numerical stability.
  for (const NoisyValue& known : values)
    course.middle_ += known.at / static_cast<double>(values.size());
  double size = 0.0;
  for (const NoisyValue& known : values)
    size = std::max(size, glm::length(known.at - course.middle_));
  if (!(size > 0.0)) return std::nullopt;
  course.scale_ = size;

  // Add up the normal equations.
  std::array<std::array<double, most_terms>, most_terms> products{};
  for (const NoisyValue& known : values) {
    const Terms terms = course.terms_at(known.at);
    for (std::size_t i = 0; i < course.count_; ++i) {
      for (std::size_t j = 0; j < course.count_; ++j)
        products[i][j] += terms[i] * terms[j] / known.variance;
      course.factors_[i] += terms[i] / known.variance * known.value;
    }
  }
  if (!solve(products, course.factors_, course.count_)) return std::nullopt;

  glm::dvec3 off(0.0);
  for (const NoisyValue& known : values) {
    const glm::dvec3 by = known.value - course.at(known.at);
    off += by * by / known.variance;
  }
  course.misfit_ = largest(off) / static_cast<double>(values.size() - course.count_);
  return course;
}

glm::dvec3 PolynomialFit::at(glm::dvec2 place) const {
  const Terms terms = terms_at(place);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < count_; ++i) sum += terms[i] * factors_[i];
  return sum;
}

}  // namespace asos
