#include "ui/refining_film.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {

namespace {

Film stretched(const Film& old, int width, int height) {
  Film film(width, height);
  if (old.width <= 0 || old.height <= 0) return film;
  film.coverage.resize(old.coverage.empty() ? 0 : film.radiance.size());
  film.unlit.resize(old.unlit.empty() ? 0 : film.radiance.size());
  for (int y = 0; y < height; ++y) {
    const int from_y = static_cast<int>(static_cast<std::int64_t>(y) * old.height / height);
    for (int x = 0; x < width; ++x) {
      const int from_x = static_cast<int>(static_cast<std::int64_t>(x) * old.width / width);
      film.radiance[film.index(x, y)] = old.radiance[old.index(from_x, from_y)];
      film.split_level[film.index(x, y)] = old.split_level[old.index(from_x, from_y)];
      film.cause[film.index(x, y)] = old.cause[old.index(from_x, from_y)];
      if (!film.coverage.empty())
        film.coverage[film.index(x, y)] = old.coverage[old.index(from_x, from_y)];
      if (!film.unlit.empty()) film.unlit[film.index(x, y)] = old.unlit[old.index(from_x, from_y)];
    }
  }
  return film;
}

/// Squared difference of linear values clipped to 0 to 1, summed over pixels and colours.
double squared_difference(const Film& film, const FinishedTile& tile) {
  double sum = 0.0;
  for (int y = 0; y < tile.rect.height; ++y) {
    for (int x = 0; x < tile.rect.width; ++x) {
      const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.rect.width) +
                        static_cast<std::size_t>(x);
      const glm::vec3 before = film.radiance[film.index(tile.rect.x + x, tile.rect.y + y)];
      const glm::vec3 d =
          glm::clamp(tile.radiance[from], 0.0f, 1.0f) - glm::clamp(before, 0.0f, 1.0f);
      sum += static_cast<double>(glm::dot(d, d));
    }
  }
  return sum;
}

}  // namespace

void RefiningFilm::begin(int width, int height) {
  pixels_taken_ = 0;
  corrected_ = 0.0;
  pixels_finished_ = 0;
  if (film_.width == width && film_.height == height) return;
  film_ = stretched(film_, width, height);
  changed_ = {{0, 0, width, height}};
}

void RefiningFilm::put(const FinishedTile& tile) {
  const std::int64_t pixels_of_tile = static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
  if (!tile.coarse) {
    corrected_ += squared_difference(film_, tile);
    pixels_finished_ += pixels_of_tile;
  }
  film_.put(tile);
  changed_.push_back(tile.rect);
  pixels_taken_ += pixels_of_tile;
}

std::optional<double> RefiningFilm::estimated_rmse() const {
  if (pixels_finished_ == 0) return std::nullopt;
  const double left =
      static_cast<double>(pixels() - pixels_finished_) / static_cast<double>(pixels());
  return std::sqrt(std::max(0.0, left) * corrected_ /
                   (3.0 * static_cast<double>(pixels_finished_)));
}

std::int64_t RefiningFilm::pixels() const {
  return static_cast<std::int64_t>(film_.width) * film_.height;
}

}  // namespace asos
