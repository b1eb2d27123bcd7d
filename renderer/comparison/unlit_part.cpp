#include "renderer/comparison/method.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Tolerance for the rounding of weights, which add up to 1.
constexpr float rounding = 1e-5f;

RenderSettings unlit_pass(RenderSettings settings, PixelContent content) {
  settings = coverage_of(std::move(settings));
  settings.background.kind = BackgroundKind::transparent;
  settings.background.content = content;
  settings.judged_tone = ToneCurve::none;
  return settings;
}

}  // namespace

UnlitPasses::UnlitPasses(const RenderSettings& settings)
    : share(unlit_pass(settings, PixelContent::unlit_share)),
      colour(unlit_pass(settings, PixelContent::unlit_colour)) {}

bool has_unlit(const World& world) {
  return std::any_of(world.parts.begin(), world.parts.end(), [&](const Part& part) {
    return !part.shows_nothing() && world.materials[part.material].unlit;
  });
}

void add_unlit_share(const BlockResult& share, BlockResult& result) {
  FinishedTile& tile = result.tile;
  tile.unlit.clear();
  const auto& found = share.tile.radiance;
  const auto none = [](glm::vec3 s) { return s == glm::vec3(0.0f); };
  if (found.size() != tile.radiance.size() || std::all_of(found.begin(), found.end(), none)) return;
  tile.unlit.reserve(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    // The channels differ behind tinted glass.
    const float mean = (found[i].x + found[i].y + found[i].z) / 3.0f;
    const float rounded = mean > 1.0f - rounding ? 1.0f : std::max(mean, 0.0f);
    tile.unlit.emplace_back(rounded > 0.0f ? tile.radiance[i] : glm::vec3(0.0f), rounded);
  }
}

bool needs_unlit_colour(const FinishedTile& tile) {
  return std::any_of(tile.unlit.begin(), tile.unlit.end(),
                     [](glm::vec4 part) { return part.w > 0.0f && part.w < 1.0f; });
}

void add_unlit_colour(const BlockResult& colour, BlockResult& result) {
  FinishedTile& tile = result.tile;
  if (colour.tile.radiance.size() != tile.unlit.size()) return;
  for (std::size_t i = 0; i < tile.unlit.size(); ++i)
    if (tile.unlit[i].w < 1.0f) tile.unlit[i] = glm::vec4(colour.tile.radiance[i], tile.unlit[i].w);
}

void add_unlit(const BlockJob& job, BlockResult& result) {
  const UnlitPasses passes(job.settings);
  add_unlit_share(render_pixels(job.with(passes.share)), result);
  if (needs_unlit_colour(result.tile))
    add_unlit_colour(render_pixels(job.with(passes.colour)), result);
}

void renew_unlit(std::vector<glm::vec4> unlit, BlockResult& result) {
  for (std::size_t i = 0; i < unlit.size(); ++i)
    if (unlit[i].w == 1.0f) unlit[i] = glm::vec4(result.tile.radiance[i], 1.0f);
  result.tile.unlit = std::move(unlit);
}

}  // namespace asos
