#include "renderer/comparison/auto_exposure.h"

#include "renderer/comparison/method.h"
#include "renderer/geometry/view.h"
#include "renderer/render_block.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asos {
namespace {

constexpr int metered_pixels = 64 * 36;
constexpr int metering_samples = 1;
constexpr float shown_white = 0.97f;  // display value above which a pixel counts as white
constexpr double bright_quantile = 0.95;
constexpr double bright_radiance = 0.8;  // radiance of that quantile after exposure
constexpr double most_stops = 32.0;
constexpr double steps_a_stop = 10.0;

/// Returns the settings of the small picture, with the aspect ratio of the whole picture.
RenderSettings metering_settings(const RenderSettings& settings) {
  RenderSettings small = settings;
  const double shape = static_cast<double>(settings.width) / settings.height;
  const auto side = [](double length) {
    return std::clamp(static_cast<int>(std::lround(length)), 1, metered_pixels);
  };
  small.width = side(std::sqrt(metered_pixels * shape));
  small.height = side(std::sqrt(metered_pixels / shape));
  small.crop = {};
  small.method = Method::sobol;
  small.sampling.spp = metering_samples;
  small.seed = 0;
  small.filter_width = 1.0;
  small.background.content = PixelContent::light;
  // Transparent pixels never count as white.
  if (small.background.kind == BackgroundKind::transparent)
    small.background.kind = BackgroundKind::environment;
  return small;
}

/// Adds the radiance of the lit part of each pixel of a block.
void add_lit(const FinishedTile& tile, std::vector<glm::vec3>& lit) {
  constexpr float least_share = 0.5f;
  for (std::size_t i = 0; i < tile.radiance.size(); ++i) {
    const glm::vec4 unlit = tile.unlit.empty() ? glm::vec4(0.0f) : tile.unlit[i];
    const float share = 1.0f - unlit.w;
    if (share >= least_share)
      lit.push_back(glm::max(tile.radiance[i] - glm::vec3(unlit), 0.0f) / share);
  }
}

float brightest(glm::vec3 c) {
  return std::max({c.x, c.y, c.z});
}

}  // namespace

Metering meter(const RenderScene& scene, const Camera& camera, const RenderSettings& settings,
               ToneCurve tone, const std::stop_token& stop) {
  const RenderSettings small = metering_settings(settings);
  const View view(camera, small.width, small.height, radius_around_origin(scene.world().bounds));
  const int side = block_side(small);
  std::vector<glm::vec3> lit;
  for (int y = 0; y < small.height; y += side) {
    for (int x = 0; x < small.width; x += side) {
      if (stop.stop_requested()) return {};
      const PixelRect block{x, y, std::min(side, small.width - x),
                            std::min(side, small.height - y)};
      add_lit(render_block(scene, view, small, block, stop).tile, lit);
    }
  }
  if (lit.empty()) return {};
  Metering metered;
  const auto count = std::count_if(lit.begin(), lit.end(), [&](glm::vec3 c) {
    return brightest(tone_mapped(c, {0.0f, tone})) >= shown_white;
  });
  metered.whitened = static_cast<double>(count) / static_cast<double>(lit.size());
  const auto at = lit.begin() + static_cast<std::ptrdiff_t>(bright_quantile *
                                                            static_cast<double>(lit.size() - 1));
  std::nth_element(lit.begin(), at, lit.end(),
                   [](glm::vec3 a, glm::vec3 b) { return brightest(a) < brightest(b); });
  const auto bright = static_cast<double>(brightest(*at));
  if (!(bright > 0.0) || !std::isfinite(bright)) return metered;
  const double stops = std::clamp(std::log2(bright_radiance / bright), -most_stops, most_stops);
  metered.stops = static_cast<float>(std::round(steps_a_stop * stops) / steps_a_stop);
  return metered;
}

bool exposure_may_follow(const RenderScene& scene) {
  return !scene.geometry->stage.has_default_lighting &&
         !scene.geometry->source.starts_with("builtin:");
}

Metering usual_exposure(const RenderScene& scene, const Camera& camera,
                        const RenderSettings& settings, ToneCurve tone,
                        const std::stop_token& stop) {
  if (!exposure_may_follow(scene)) return {};
  Metering metered = meter(scene, camera, settings, tone, stop);
  if (metered.whitened <= most_whitened) metered.stops = 0.0f;
  return metered;
}

}  // namespace asos
