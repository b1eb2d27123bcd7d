#include "ui/refining_film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace asos::ui {

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
      film.samples[film.index(x, y)] = old.samples[old.index(from_x, from_y)];
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

// Replaces the pixels of a tile by the film's where these are finer. `inside`: the tile's part in
// the film.
void keep_finer(const Film& film, const std::vector<std::uint8_t>& fineness, std::uint8_t of_tile,
                const PixelRect& inside, FinishedTile& tile) {
  const bool covers = !tile.coverage.empty() && !film.coverage.empty();
  const bool unlit = !tile.unlit.empty() && !film.unlit.empty();
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const std::size_t from = film.index(x, y);
      if (fineness[from] <= of_tile) continue;
      const auto to =
          static_cast<std::size_t>(y - tile.rect.y) * static_cast<std::size_t>(tile.rect.width) +
          static_cast<std::size_t>(x - tile.rect.x);
      tile.radiance[to] = film.radiance[from];
      if (covers) tile.coverage[to] = film.coverage[from];
      if (unlit) tile.unlit[to] = film.unlit[from];
    }
  }
}

}  // namespace

void RefiningFilm::begin(const RenderSettings& settings, bool same_view) {
  view_covered_ = same_view && (view_covered_ || covered());
  pixels_taken_ = 0;
  corrected_ = 0.0;
  pixels_finished_ = 0;
  if (film_.width != settings.width || film_.height != settings.height) {
    film_ = stretched(film_, settings.width, settings.height);
    changed_ = {{0, 0, film_.width, film_.height}};
    same_view = view_covered_ = false;
  }
  std::erase_if(film_.layers,
                [&](const LayerPlane& plane) { return !settings.layers.has(plane.layer); });
  if (!same_view) {
    map_.clear(film_.radiance.size());
    fineness_.assign(film_.radiance.size(), 0);
  }
  final_fineness_ = static_cast<std::uint8_t>(2 + 2 * std::max(0, settings.asos.max_level));
  predict(settings);
  map_.render_by(settings);
  film_.unfinished.assign(film_.radiance.size(), 1);
  ++map_revision_;
}

void RefiningFilm::show(const RefiningFilm& kept) {
  const std::uint64_t revision = map_revision_;
  *this = kept;
  map_revision_ = revision + 1;
  changed_ = {{0, 0, film_.width, film_.height}};
}

void RefiningFilm::predict(const RenderSettings& asked) {
  if (map_.predict(asked, film_)) ++map_revision_;
}

void RefiningFilm::put(FinishedTile tile, int samples) {
  const std::int64_t pixels_of_tile = static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
  pixels_taken_ += pixels_of_tile;
  if (tile.coarse) return put_coarse(std::move(tile), samples);
  corrected_ += squared_difference(film_, tile);
  pixels_finished_ += pixels_of_tile;
  std::vector<SplitPredictionData> outlook = std::exchange(tile.outlook, {});  // the map keeps it
  film_.put(tile);
  tile.outlook = std::move(outlook);
  finish(tile);
  changed_.push_back(tile.rect);
}

void RefiningFilm::put_coarse(FinishedTile tile, int samples) {
  // Only samples of pixels come with a time. Squares of one colour add nothing to a covered view.
  const bool sampled = samples > 0 || !tile.seconds.empty();
  if (view_covered_ && !sampled) return;
  const unsigned least = sampled ? std::max(1u, static_cast<unsigned>(samples)) : 0u;
  const auto of_tile = static_cast<std::uint8_t>(std::bit_width(least));
  const PixelRect inside = intersection(tile.rect, {0, 0, film_.width, film_.height});
  bool all_finer = true;
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    const auto row = fineness_.begin() + static_cast<std::ptrdiff_t>(film_.index(inside.x, y));
    all_finer = all_finer && std::all_of(row, row + inside.width,
                                         [&](std::uint8_t held) { return held > of_tile; });
  }
  if (all_finer) return;
  map_.complete(tile, film_);
  keep_finer(film_, fineness_, of_tile, inside, tile);
  tile.outlook.clear();
  film_.put(tile);
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    const auto row = fineness_.begin() + static_cast<std::ptrdiff_t>(film_.index(inside.x, y));
    std::transform(row, row + inside.width, row,
                   [&](std::uint8_t held) { return std::max(held, of_tile); });
  }
  changed_.push_back(tile.rect);
}

void RefiningFilm::finish(const FinishedTile& tile) {
  map_.note_final(tile, film_);
  const PixelRect inside = intersection(tile.rect, {0, 0, film_.width, film_.height});
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    const auto first = static_cast<std::ptrdiff_t>(film_.index(inside.x, y));
    std::fill_n(film_.unfinished.begin() + first, inside.width, std::uint8_t{0});
    std::fill_n(fineness_.begin() + first, inside.width, final_fineness_);
  }
}

double RefiningFilm::split_share() const {
  std::size_t split = 0;
  for (std::size_t i = 0; i < film_.cause.size(); ++i)
    split += film_.split_level[i] > 0 || film_.cause[i] != SplitCause::none;
  return static_cast<double>(split) / std::max<double>(1.0, static_cast<double>(pixels()));
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

}  // namespace asos::ui
