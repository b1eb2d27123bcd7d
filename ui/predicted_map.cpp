#include "ui/predicted_map.h"

#include "renderer/asos/predicted_level.h"

#include <algorithm>
#include <utility>

namespace asos::ui {

namespace {

constexpr std::size_t most_origins = 64;

bool same_splitting(const RenderSettings& a, const RenderSettings& b) {
  return a.asos.eps == b.asos.eps && a.asos.max_level == b.asos.max_level;
}

/// Whether settings split as deeply as others everywhere.
bool is_finer(const RenderSettings& a, const RenderSettings& than) {
  return a.asos.eps <= than.asos.eps && a.asos.max_level >= than.asos.max_level;
}

/// Calls `f` with the index of each pixel of a tile in the film and in the tile. Skips pixels
/// outside the film.
template <typename F>
void each_pixel(const FinishedTile& tile, const Film& film, const F& f) {
  const PixelRect inside = intersection(tile.rect, {0, 0, film.width, film.height});
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const int in_tile = (y - tile.rect.y) * tile.rect.width + x - tile.rect.x;
      f(film.index(x, y), static_cast<std::size_t>(in_tile));
    }
  }
}

}  // namespace

void PredictedMap::clear(std::size_t pixels) {
  known_.assign(pixels, {});
  origins_.clear();
  rendering_ = unknown;
}

std::uint16_t PredictedMap::index_of(const RenderSettings& settings) {
  const auto at = std::find_if(origins_.begin(), origins_.end(), [&](const RenderSettings& known) {
    return same_splitting(known, settings);
  });
  if (at != origins_.end()) return static_cast<std::uint16_t>(at - origins_.begin());
  if (origins_.size() >= most_origins) drop_unused();
  origins_.push_back(settings);
  return static_cast<std::uint16_t>(origins_.size() - 1);
}

// Removes settings that no pixel was rendered with: a long drag leaves many.
void PredictedMap::drop_unused() {
  std::vector<std::uint16_t> renamed(origins_.size(), unknown);
  for (const Known& pixel : known_)
    if (pixel.origin != unknown) renamed[pixel.origin] = 0;
  std::vector<RenderSettings> used;
  for (std::size_t i = 0; i < origins_.size(); ++i) {
    if (renamed[i] == unknown) continue;
    renamed[i] = static_cast<std::uint16_t>(used.size());
    used.push_back(origins_[i]);
  }
  for (Known& pixel : known_)
    if (pixel.origin != unknown) pixel.origin = renamed[pixel.origin];
  origins_ = std::move(used);
}

void PredictedMap::render_by(const RenderSettings& settings) {
  rendering_ = index_of(settings);
  asked_ = settings;
}

// `pixels` calls its argument with the index of each pixel to update.
template <typename Pixels>
void PredictedMap::show(const Pixels& pixels, Film& film) const {
  std::vector<LevelPrediction> predictions;
  predictions.reserve(origins_.size());
  for (const RenderSettings& origin : origins_) predictions.emplace_back(origin, asked_);
  pixels([&](std::size_t i) {
    const Known& pixel = known_[i];
    if (pixel.origin == unknown) return;
    film.split_level[i] = pixel.level;
    film.cause[i] = pixel.cause;
    film.samples[i] = shown_count(pixel.outlook);
    if (same_splitting(origins_[pixel.origin], asked_)) return;
    int level = predictions[pixel.origin].level_of(pixel.outlook);
    const std::uint32_t samples = predictions[pixel.origin].samples_of(pixel.outlook, pixel.cause);
    // A pixel is split by finer settings if it was by coarser ones.
    if (is_finer(asked_, origins_[pixel.origin])) level = std::max<int>(level, pixel.level);
    film.split_level[i] = static_cast<std::uint8_t>(level);
    film.samples[i] = static_cast<std::uint16_t>(std::min(samples, 0xffffu));
    // Edges are found at any setting, so a pixel without any that is predicted to be split is so
    // for its shading.
    if (level > 0 || samples > 0) {
      if (pixel.cause == SplitCause::none) film.cause[i] = SplitCause::shading;
    } else if (pixel.cause == SplitCause::shading) {
      film.cause[i] = SplitCause::none;
    }
  });
}

bool PredictedMap::predict(const RenderSettings& asked, Film& film) {
  if (same_splitting(asked, asked_) || film.split_level.size() != known_.size()) return false;
  asked_ = asked;
  show(
      [&](const auto& pixel) {
        for (std::size_t i = 0; i < known_.size(); ++i) pixel(i);
      },
      film);
  return true;
}

void PredictedMap::note_final(const FinishedTile& tile, Film& film) {
  const bool told = !tile.outlook.empty() && rendering_ != unknown;
  each_pixel(tile, film, [&](std::size_t i, std::size_t k) {
    known_[i] = {};
    if (!told) return;
    known_[i] = {tile.outlook[k], rendering_, tile.split_level[k], tile.cause[k]};
    film.samples[i] = shown_count(tile.outlook[k]);
  });
  if (!told || same_splitting(origins_[rendering_], asked_)) return;
  show([&](const auto& pixel) { each_pixel(tile, film, [&](std::size_t i, auto) { pixel(i); }); },
       film);
}

void PredictedMap::complete(FinishedTile& coarse, const Film& film) const {
  const std::size_t pixels = coarse.radiance.size();
  coarse.rays.resize(pixels, 0.0f);
  coarse.seconds.resize(pixels, 0.0f);
  each_pixel(coarse, film, [&](std::size_t i, std::size_t k) {
    if (known_[i].origin == unknown) return;
    coarse.split_level[k] = std::max(coarse.split_level[k], film.split_level[i]);
    if (coarse.cause[k] == SplitCause::none) coarse.cause[k] = film.cause[i];
    coarse.rays[k] = std::max(coarse.rays[k], film.rays[i]);
    coarse.seconds[k] = std::max(coarse.seconds[k], film.seconds[i]);
  });
}

}  // namespace asos::ui
