#include "renderer/samples/sample_block.h"

#include "renderer/samples/pixel_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {

void PixelSampler::on_light(std::uint32_t light, LightPointBatch& places) {
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

void PixelSampler::in_pixel(int first, std::span<PixelPoint> points) {
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

BlockResult sample_block(const BlockJob& job, PixelSampler& places, int samples) {
  PixelSamples pixels(job.block);
  while (pixels.taken() < samples && !job.stop.stop_requested())
    pixels.advance(job, places, PixelSamples::after_round(pixels.taken(), samples), samples);
  return pixels.result();
}

}  // namespace asos
