#pragma once

#include "renderer/kernels/sobol_kernel.h"
#include "renderer/samples/sample_block.h"
#include "renderer/sampling/sobol_points.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// Samples by an Owen-scrambled Sobol sequence over each pixel and each light.
class SobolSampler final : public PixelSampler {
 public:
  explicit SobolSampler(int seed) : seed_(static_cast<std::uint32_t>(seed)) {}

  void start_pixel(int x, int y) override {
    points_.emplace(x, y, seed_);
    in_pixel_.forget();
  }
  void start_sample(int index) override { index_ = static_cast<std::uint32_t>(index); }
  [[nodiscard]] PixelPoint in_pixel() const override {
    const glm::dvec2 p = in_pixel_.at(*points_, index_);
    return {p.x, p.y};
  }
  void in_pixel(int first, std::span<PixelPoint> points) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      index_ = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i);
      const glm::dvec2 p = in_pixel_.at(*points_, index_);
      points[i] = {p.x, p.y};
    }
  }
  [[nodiscard]] glm::dvec2 on_light(std::uint32_t light) const override {
    return points_->light(lens_ || time_ ? points_->shuffled(index_) : index_, light);
  }
  [[nodiscard]] glm::dvec2 in_lobe(SampleStream stream, int k) const override {
    return points_->lobe(index_, stream, static_cast<std::uint32_t>(k));
  }

  void use_lens() override { lens_ = true; }
  [[nodiscard]] glm::dvec2 on_lens() const override { return points_->lens(index_); }

  void use_time() override { time_ = true; }
  [[nodiscard]] double in_time() const override { return points_->time(index_, lens_); }

  void start_batch(std::span<const SampleIndex> samples) override {
    batch_.clear();
    std::optional<SobolPixel> pixel;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const SampleIndex& sample = samples[i];
      const bool same = i > 0 && sample.same_pixel(samples[i - 1]);
      if (!same) pixel.emplace(sample.x, sample.y, seed_);
      auto index = static_cast<std::uint32_t>(sample.index);
      if (lens_ || time_) index = pixel->shuffled(index);
      if (same)
        batch_.add(index);
      else
        batch_.add(*pixel, index);
    }
  }
  void on_light(std::uint32_t light, LightPointBatch& places) override {
    batch_.on_light(light, places);
  }
  void on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                LightPointBatch& places) override {
    batch_.on_light(light, of, places);
  }

 private:
  std::uint32_t seed_;
  std::optional<SobolPixel> points_;
  std::uint32_t index_ = 0;
  bool lens_ = false;
  bool time_ = false;
  mutable SobolPixelSampler in_pixel_;
  SobolBatch batch_;
};

}  // namespace asos
