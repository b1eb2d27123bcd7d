#pragma once

#include "tests/support/render_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos::test {

/// Differences of red, in linear radiance, between two pictures of equal size.
struct Difference {
  double largest = 0.0;
  double rmse = 0.0;
  double bias = 0.0;  ///< mean of the first minus that of the second
  double mean = 0.0;  ///< of the second
};

inline Difference difference(const Picture& a, const Picture& b) {
  Difference found;
  const auto count = static_cast<double>(a.film.radiance.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < a.film.radiance.size(); ++i) {
    const auto d = static_cast<double>(a.film.radiance[i].x - b.film.radiance[i].x);
    found.largest = std::max(found.largest, std::abs(d));
    squares += d * d;
    found.bias += d / count;
    found.mean += static_cast<double>(b.film.radiance[i].x) / count;
  }
  found.rmse = std::sqrt(squares / count);
  return found;
}

}  // namespace asos::test
