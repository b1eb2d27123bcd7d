#pragma once

#include "renderer/samples/sample_block.h"
#include "renderer/sampling/sobol_points.h"

#include <cstdint>
#include <optional>

namespace asos {

/// The points of an Owen-scrambled Sobol sequence over each pixel and each light.
class SobolPlaces final : public SamplePlaces {
 public:
  explicit SobolPlaces(int seed) : seed_(static_cast<std::uint32_t>(seed)) {}

  void start_pixel(int x, int y) override { points_.emplace(x, y, seed_); }
  void start_sample(int index) override { index_ = static_cast<std::uint32_t>(index); }
  [[nodiscard]] PixelPoint in_pixel() const override {
    const glm::dvec2 p = points_->pixel(index_);
    return {p.x, p.y};
  }
  [[nodiscard]] glm::dvec2 on_light(std::uint32_t light) const override {
    return points_->light(index_, light);
  }
  [[nodiscard]] glm::dvec2 in_lobe(int bounce) const override {
    return points_->lobe(index_, static_cast<std::uint32_t>(bounce));
  }

 private:
  std::uint32_t seed_;
  std::optional<SobolPixel> points_;
  std::uint32_t index_ = 0;
};

}  // namespace asos
