#include "renderer/samples/sample_block.h"

#include "renderer/samples/pixel_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace asos {

void PixelSampler::on_light(std::uint32_t light, LightPointBatch& places) {
  std::array<std::uint32_t, ShadingPoints::size> all;
  std::iota(all.begin(), all.end(), 0u);
  on_light(light, std::span(all).first(batch_.size()), places);
}

void PixelSampler::on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                            LightPointBatch& places) {
  for (std::size_t k = 0; k < of.size(); ++k) {
    const SampleIndex& sample = batch_[of[k]];
    if (k == 0 || !sample.same_pixel(batch_[of[k - 1]])) start_pixel(sample.x, sample.y);
    start_sample(sample.index);
    constexpr double scale = 4294967296.0;
    const glm::dvec2 at = glm::min(scale * on_light(light), scale - 1.0);
    places.u[k] = static_cast<std::uint32_t>(at.x);
    places.v[k] = static_cast<std::uint32_t>(at.y);
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
