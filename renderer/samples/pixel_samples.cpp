#include "renderer/samples/pixel_samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace asos {
namespace {

glm::vec3 shown(const SampleSums::Sum& sum) {
  return glm::vec3(glm::clamp(sum.mean(), glm::dvec3(0.0), glm::dvec3(1.0)));
}

bool is_power_of_four(int samples) {
  const auto n = static_cast<unsigned>(samples);
  return std::has_single_bit(n) && std::countr_zero(n) % 2 == 0;
}

/// Adds samples of one pixel, number `target` of the sums. Returns false after a stop request.
bool add_samples(const BlockJob& job, PixelSampler& places, const ContinuedPixel& pixel,
                 std::size_t target, int end, float side, SampleSums& sums) {
  std::array<PixelPoint, points_at_a_time> points;
  const double width = job.settings.filter_width;
  places.start_pixel(pixel.x, pixel.y);
  for (int first = pixel.taken; first < end; first += points_at_a_time) {
    const auto some = static_cast<std::size_t>(std::min(points_at_a_time, end - first));
    places.in_pixel(first, std::span(points).first(some));
    bool traced = false;
    for (std::size_t i = 0; i < some; ++i) {
      const glm::dvec2 at(pixel.x + 0.5 + width * (points[i].x - 0.5),
                          pixel.y + 0.5 + width * (points[i].y - 0.5));
      traced |= sums.add({at, side, pixel.x, pixel.y, first + static_cast<int>(i), target});
    }
    if (!traced) continue;
    if (job.stop.stop_requested()) return false;
    places.start_pixel(pixel.x, pixel.y);
  }
  return true;
}

}  // namespace

RenderStatistics continue_pixels(const BlockJob& job, PixelSampler& places,
                                 std::span<ContinuedPixel> pixels, int end, int footprints) {
  SampleSums sums(job, places);
  sums.resize(pixels.size());
  LayerTargets targets;
  if (job.settings.layers.of_surfaces()) {
    for (const ContinuedPixel& pixel : pixels) targets.add(*pixel.layers);
    sums.note_layers(job.settings, targets);
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) sums.continue_from(i, pixels[i].sum);
  const double width = job.settings.filter_width;
  const float side = sample_side(width, footprints);
  sums.widen_colours(
      std::max(1.0f, colour_side * static_cast<float>(width / std::sqrt(footprints)) / side));
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (!add_samples(job, places, pixels[i], i, end, side, sums)) return sums.statistics();
  sums.trace();
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i].sum = sums.sum(i);
  return sums.statistics();
}

PixelSamples::PixelSamples(PixelRect block)
    : block_(block),
      pixels_(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height)) {}

int PixelSamples::after_round(int taken, int most) {
  return std::min(most, std::max(1, 2 * taken));
}

void PixelSamples::advance(const BlockJob& job, PixelSampler& places, int end, int footprints) {
  if (end <= taken_) return;
  if (job.settings.layers.of_surfaces()) {
    asked_ = job.settings.layers;
    layers_.resize(pixels_.size());
  }
  std::vector<ContinuedPixel> pixels;
  pixels.reserve(pixels_.size());
  for (int y = block_.y; y < block_.y + block_.height; ++y) {
    for (int x = block_.x; x < block_.x + block_.width; ++x) {
      const std::size_t i = pixels.size();
      pixels.push_back(
          {x, y, pixels_[i].taken, pixels_[i].sum, layers_.empty() ? nullptr : &layers_[i]});
    }
  }
  statistics_ += continue_pixels(job, places, pixels, end, footprints);
  if (job.stop.stop_requested()) return;
  for (std::size_t i = 0; i < pixels.size(); ++i) put(i, end, pixels[i].sum, nullptr);
  taken_ = end;
}

void PixelSamples::put(std::size_t pixel, int taken, const SampleSums::Sum& sum,
                       const LayerSum* layers) {
  Pixel& own = pixels_[pixel];
  const glm::vec3 now = shown(sum), off = now - own.before;
  own.moved = own.taken > 0 ? glm::dot(off, off) : 0.0f;
  own.taken = taken;
  own.sum = sum;
  if (is_power_of_four(taken)) own.before = now;
  if (layers) layers_[pixel] = *layers;
}

BlockResult PixelSamples::result() const {
  return {tile(block_), statistics_};
}

FinishedTile PixelSamples::tile(const PixelRect& part) const {
  FinishedTile tile;
  tile.rect = part;
  const auto count = static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height);
  tile.split_level.assign(count, 0);
  tile.radiance.reserve(count);
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x)
      tile.radiance.emplace_back(pixels_[index(x, y)].sum.mean());
  if (layers_.empty()) return tile;
  if (part == block_) {
    tile.layers = planes_of(layers_, asked_);
    return tile;
  }
  std::vector<LayerSum> layers;
  layers.reserve(count);
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) layers.push_back(layers_[index(x, y)]);
  tile.layers = planes_of(layers, asked_);
  return tile;
}

double PixelSamples::moved() const {
  double sum = 0.0;
  for (const Pixel& pixel : pixels_) sum += static_cast<double>(pixel.moved);
  return sum;
}

}  // namespace asos
