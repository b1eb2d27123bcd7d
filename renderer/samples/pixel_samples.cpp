#include "renderer/samples/pixel_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace asos {
namespace {

glm::dvec3 shown(const SampleSums::Sum& sum) {
  return glm::clamp(sum.mean(), glm::dvec3(0.0), glm::dvec3(1.0));
}

}  // namespace

PixelSamples::PixelSamples(PixelRect block)
    : block_(block),
      sums_(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height)),
      moved_(sums_.size(), 0.0f) {}

int PixelSamples::after_round(int taken, int most) {
  return std::min(most, std::max(1, 2 * taken));
}

void PixelSamples::advance(const BlockJob& job, PixelSampler& places, int end, int footprints) {
  if (end <= taken_) return;
  SampleSums sums(job, places);
  sums.resize(sums_.size());
  LayerTargets targets;
  if (job.settings.layers.of_surfaces()) {
    asked_ = job.settings.layers;
    layers_.resize(sums_.size());
    for (LayerSum& layer : layers_) targets.add(layer);
    sums.note_layers(job.settings, targets);
  }
  for (std::size_t i = 0; i < sums_.size(); ++i) sums.continue_from(i, sums_[i]);
  const double width = job.settings.filter_width;
  const float side = sample_side(width, footprints);
  sums.widen_colours(
      std::max(1.0f, colour_side * static_cast<float>(width / std::sqrt(footprints)) / side));
  std::array<PixelPoint, points_at_a_time> points;
  std::size_t pixel = 0;
  for (int y = block_.y; y < block_.y + block_.height; ++y) {
    for (int x = block_.x; x < block_.x + block_.width; ++x, ++pixel) {
      places.start_pixel(x, y);
      for (int first = taken_; first < end; first += points_at_a_time) {
        const auto some = static_cast<std::size_t>(std::min(points_at_a_time, end - first));
        places.in_pixel(first, std::span(points).first(some));
        bool traced = false;
        for (std::size_t i = 0; i < some; ++i) {
          const glm::dvec2 at(x + 0.5 + width * (points[i].x - 0.5),
                              y + 0.5 + width * (points[i].y - 0.5));
          traced |= sums.add({at, side, x, y, first + static_cast<int>(i), pixel});
        }
        if (!traced) continue;
        if (job.stop.stop_requested()) return;
        places.start_pixel(x, y);
      }
    }
  }
  sums.trace();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const SampleSums::Sum next = sums.sum(i);
    const glm::dvec3 off = shown(next) - shown(sums_[i]);
    moved_[i] = taken_ > 0 ? static_cast<float>(glm::dot(off, off)) : 0.0f;
    sums_[i] = next;
  }
  statistics_ += sums.statistics();
  taken_ = end;
}

BlockResult PixelSamples::result() const {
  BlockResult result;
  result.statistics = statistics_;
  result.tile.rect = block_;
  result.tile.split_level.assign(sums_.size(), 0);
  result.tile.radiance.reserve(sums_.size());
  for (const SampleSums::Sum& sum : sums_) result.tile.radiance.emplace_back(sum.mean());
  if (!layers_.empty()) result.tile.layers = planes_of(layers_, asked_);
  return result;
}

}  // namespace asos
