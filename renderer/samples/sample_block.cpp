#include "renderer/samples/sample_block.h"

#include "renderer/samples/sample_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asos {

void SamplePlaces::on_light(std::uint32_t light, LightPlaceBatch& places) {
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    const SampleIndex& sample = batch_[i];
    if (i == 0 || !sample.same_pixel(batch_[i - 1])) start_pixel(sample.x, sample.y);
    start_sample(sample.index);
    constexpr double scale = 4294967296.0;
    const glm::dvec2 at = glm::min(scale * on_light(light), scale - 1.0);
    places.u[i] = static_cast<std::uint32_t>(at.x);
    places.v[i] = static_cast<std::uint32_t>(at.y);
  }
}

void SamplePlaces::in_pixel(int first, std::span<PixelPoint> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    start_sample(first + static_cast<int>(i));
    points[i] = in_pixel();
  }
}

int grid_side(int spp) {
  int n = 1;
  while (n * n < spp) ++n;
  return n;
}

float sample_side(double width, int samples) {
  constexpr int few = 4;
  const double side = width / std::sqrt(samples);
  return static_cast<float>(samples > few ? 0.5 * side : side);
}

BlockResult sample_block(const BlockJob& job, SamplePlaces& places, int samples) {
  const PixelRect& block = job.block;
  SampleSums sums(job.scene, job.view, job.settings, places);
  sums.resize(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
  const double width = job.settings.filter_width;
  const float side = sample_side(width, samples);
  sums.widen_colours(
      std::max(1.0f, colour_side * static_cast<float>(width / std::sqrt(samples)) / side));
  std::array<PixelPoint, points_at_a_time> points;
  std::size_t pixel = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++pixel) {
      places.start_pixel(x, y);
      for (int first = 0; first < samples; first += points_at_a_time) {
        const auto some = static_cast<std::size_t>(std::min(points_at_a_time, samples - first));
        places.in_pixel(first, std::span(points).first(some));
        bool traced = false;
        for (std::size_t i = 0; i < some; ++i) {
          const glm::dvec2 at(x + 0.5 + width * (points[i].x - 0.5),
                              y + 0.5 + width * (points[i].y - 0.5));
          traced |= sums.add({at, side, x, y, first + static_cast<int>(i), pixel});
        }
        if (!traced) continue;
        if (job.stop.stop_requested()) return sums.block(block);
        places.start_pixel(x, y);
      }
    }
  }
  sums.trace();
  return sums.block(block);
}

}  // namespace asos
