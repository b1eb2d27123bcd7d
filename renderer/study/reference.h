#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace asos {

/// An estimate of the true picture from two independent halves, which tell how noisy it is. Each
/// half is the mean of its passes, weighted by their samples.
class Reference {
 public:
  /// Adds a pass of both halves. All films are of one size.
  void add(const Film& first, const Film& second, int samples);

  [[nodiscard]] int passes() const { return passes_; }
  /// The samples of a pixel, in both halves together.
  [[nodiscard]] long samples() const { return 2L * samples_; }

  /// The mean of both halves. There is at least one pass.
  [[nodiscard]] Film film() const;

  /// The standard error of `film`, root mean square over pixels and channels, of radiance clipped
  /// to 0..1: half of the difference of the halves, for the variance of their mean is a quarter of
  /// that of their difference.
  [[nodiscard]] double noise() const;
  /// The mean of one half's passes; `which` is 0 or 1.
  [[nodiscard]] Film half(std::size_t which) const;

 private:
  int width_ = 0;
  int height_ = 0;
  int passes_ = 0;
  int samples_ = 0;
  std::array<std::vector<glm::dvec3>, 2> sums_;
};

/// Whether a reference is quiet enough for a smallest error: its noise adds no more than 3 % to it.
[[nodiscard]] bool quiet_enough(double noise, double smallest_error);

/// Errors below this are hardly known: a reference's noise would be more than 12 % of them.
[[nodiscard]] double floor_of(double noise);

}  // namespace asos
