#include "renderer/methods/sample_block.h"
#include "renderer/sampling/sobol_points.h"

#include <optional>

namespace asos {
namespace {

class SobolPlaces final : public SamplePlaces {
 public:
  explicit SobolPlaces(std::uint32_t seed) : seed_(seed) {}

  void start_pixel(int x, int y) override { points_.emplace(x, y, seed_); }
  void start_sample(int index) override { index_ = static_cast<std::uint32_t>(index); }
  [[nodiscard]] PixelPoint in_pixel() const override {
    const glm::dvec2 p = points_->pixel(index_);
    return {p.x, p.y};
  }
  [[nodiscard]] glm::dvec2 on_light(std::uint32_t light) const override {
    return points_->light(index_, light);
  }

 private:
  std::uint32_t seed_;
  std::optional<SobolPixel> points_;
  std::uint32_t index_ = 0;
};

}  // namespace

BlockResult render_block_sobol(const RenderScene& scene, const View& view,
                               const RenderSettings& settings, PixelRect block,
                               const std::stop_token& stop) {
  SobolPlaces places(static_cast<std::uint32_t>(settings.seed));
  return sample_block(scene, view, settings, block, places, settings.spp, stop);
}

}  // namespace asos
