#include "ui/resampled.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace asos::ui {

namespace {

/// The pixels of a row or column that one resampled pixel covers, and their weights.
struct Covered {
  int first = 0;
  std::vector<float> weights;  ///< with the sum 1, or empty
};

/// Coverage of `count` resampled pixels over `from` pixels, centred; each is `step` pixels wide.
std::vector<Covered> cover(int from, int count, double step) {
  std::vector<Covered> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double lo = 0.5 * from + step * (i - 0.5 * count);
    const double begin = std::max(lo, 0.0), end = std::min(lo + step, double(from));
    Covered& covered = all[static_cast<std::size_t>(i)];
    // A sliver from rounding is no pixel.
    if (!(end - begin > 1e-6 * step)) continue;
    covered.first = std::min(static_cast<int>(begin), from - 1);
    double sum = 0.0;
    for (int k = covered.first; k < from && k < end; ++k) {
      const double part = std::min(end, k + 1.0) - std::max(begin, double(k));
      covered.weights.push_back(static_cast<float>(std::max(part, 0.0)));
      sum += std::max(part, 0.0);
    }
    for (float& weight : covered.weights) weight /= static_cast<float>(sum);
  }
  return all;
}

}  // namespace

PixelRect resampled_area(const Film& film, glm::ivec2 size) {
  if (film.height <= 0 || size.x <= 0 || size.y <= 0) return {};
  const int width =
      static_cast<int>(std::ceil(static_cast<double>(film.width) * size.y / film.height - 1e-6));
  const int beyond = std::max(0, (size.x - width) / 2);
  return {beyond, 0, size.x - 2 * beyond, size.y};
}

Film resampled(const Film& film, glm::ivec2 size) {
  Film result(size.x, size.y);
  if (!film.coverage.empty()) result.coverage.assign(result.radiance.size(), 1.0f);
  if (!film.unlit.empty()) result.unlit.assign(result.radiance.size(), glm::vec4(0.0f));
  if (film.width <= 0 || film.height <= 0 || size.x <= 0 || size.y <= 0) return result;
  const double step = static_cast<double>(film.height) / size.y;
  const std::vector<Covered> columns = cover(film.width, size.x, step);
  const std::vector<Covered> rows = cover(film.height, size.y, step);
  for (int y = 0; y < size.y; ++y) {
    const Covered& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < size.x; ++x) {
      const Covered& column = columns[static_cast<std::size_t>(x)];
      glm::vec3 sum(0.0f);
      float covered = 0.0f;
      glm::vec4 unlit(0.0f);
      for (std::size_t k = 0; k < row.weights.size(); ++k) {
        const std::size_t line = film.index(column.first, row.first + static_cast<int>(k));
        for (std::size_t i = 0; i < column.weights.size(); ++i) {
          const float weight = row.weights[k] * column.weights[i];
          sum += weight * film.radiance[line + i];
          if (!film.coverage.empty()) covered += weight * film.coverage[line + i];
          if (!film.unlit.empty()) unlit += weight * film.unlit[line + i];
        }
      }
      result.radiance[result.index(x, y)] = sum;
      if (!film.coverage.empty()) result.coverage[result.index(x, y)] = covered;
      if (!film.unlit.empty()) result.unlit[result.index(x, y)] = unlit;
    }
  }
  return result;
}

}  // namespace asos::ui
