#pragma once

#include "renderer/film/film.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace asos {

/// An estimate of the true picture from two independent halves, whose difference gives its noise.
/// Each half is the mean of its passes, weighted by their samples.
class Reference {
 public:
  /// Adds a pass of both halves. All films have the same size.
  void add(const Film& first, const Film& second, int samples);

  [[nodiscard]] int passes() const { return passes_; }
  /// Returns the samples per pixel, in both halves together.
  [[nodiscard]] long samples() const { return 2L * samples_; }

  /// Returns the mean of both halves. There must be at least one pass.
  [[nodiscard]] Film film() const;

  /// Returns the standard error of `film`, root mean square over pixels and channels, for radiance
  /// clipped to 0..1. It is half of the halves' difference, since the variance of their mean is a
  /// quarter of that of their difference.
  [[nodiscard]] double noise() const;
  /// Returns the mean of one half's passes; `which` is 0 or 1.
  [[nodiscard]] Film half(std::size_t which) const;

 private:
  int width_ = 0;
  int height_ = 0;
  int passes_ = 0;
  int samples_ = 0;
  std::array<std::vector<glm::dvec3>, 2> sums_;
};

/// Returns whether a reference's noise adds at most 3 % to the smallest error.
[[nodiscard]] bool quiet_enough(double noise, double smallest_error);

/// Returns the error below which a reference's noise would add more than 12 % to it.
[[nodiscard]] double floor_of(double noise);

}  // namespace asos
