#include "renderer/asos/started_pyray.h"

#include "renderer/asos/split_causes.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace asos {
namespace {

// Rays of the block that belong to no pixel are distributed over its pixels. An example are rays
// that test whether a patch is evenly lit.
void publish_rays(std::span<const std::uint64_t> rays, BlockResult& result) {
  std::uint64_t known = 0;
  for (const std::uint64_t of_pixel : rays) {
    known += of_pixel;
    result.tile.rays.push_back(static_cast<float>(of_pixel));
  }
  const std::uint64_t all = result.statistics.rays();
  if (all <= known) return;
  const float shared = static_cast<float>(all - known) / static_cast<float>(rays.size());
  for (float& of_pixel : result.tile.rays) of_pixel += shared;
}

// Returns the deepest level at which cells were examined. Cutting a cell adds no level.
int deepest_cell(const SubdivisionOutcome& outcome) {
  int deepest = 0;
  for (std::size_t k = 0; k < outcome.pyrays_by_level.size(); ++k)
    if (outcome.pyrays_by_level[k] > 0) deepest = static_cast<int>(k);
  return deepest;
}

// Returns the number of samples that the split map shows. Where EPS makes samples the cheapest
// choice, every lit pixel takes the pilot's samples, and those do not count.
std::uint32_t shown_samples(const SubdivisionOutcome& outcome, const RootSum& sum) {
  const bool for_cause =
      outcome.uneven_shading || outcome.uneven_shadow || outcome.saturated || sum.cut_out;
  return for_cause ? sum.samples : sum.varied;
}

SplitPredictionData outlook_of(const SubdivisionOutcome& outcome, const RootSum& sum) {
  SplitPredictionData outlook;
  outlook.error = sum.error;
  outlook.unresolved = static_cast<float>(outcome.unresolved_area);
  outlook.samples = shown_samples(outcome, sum);
  outlook.edges = static_cast<std::uint8_t>(outcome.boundaries.empty() ? 0 : deepest_cell(outcome));
  outlook.at_limit = outcome.at_limit;
  return outlook;
}

// Returns the expected error of a pixel in display intensity: the root of the summed squares of the
// errors of sampled parts, of leaves shaded at their centres, and of a fraction of the tolerance.
double error_estimate(const RootSum& sum, double tolerance) {
  const double usual = LeafTuning::share_of_tolerance * tolerance,
               centres = LeafTuning::share_of_bound * sum.centre_error;
  return std::sqrt(sum.squared_error + centres * centres + usual * usual);
}

// Publishes a pixel's radiance, level, cause and rays, and counts its cells and events.
void publish_pixel(const Trace& trace, const RootSum& sum, int max_level, BlockResult& result,
                   std::vector<std::uint64_t>& rays) {
  RenderStatistics& statistics = result.statistics;
  SubdivisionOutcome outcome = trace.outcome;
  const auto& cells = outcome.pyrays_by_level;
  for (std::size_t k = 0; k < cells.size(); ++k) statistics.pyrays_by_level[k] += cells[k];
  // Samples add no level: they have a number of their own. Sampled pixels have a cause, too.
  const int level = deepest_cell(outcome);
  const bool sampled = max_level > 0 && (sum.cut_out || shown_samples(outcome, sum) > 1);
  outcome.deepest = std::max({outcome.deepest, level, sampled ? 1 : 0});
  if (sum.varied > 0 && !outcome.uneven_shadow) outcome.uneven_shading = true;
  statistics.missed_splits += trace.missed;
  statistics.uneven_pixels += outcome.uneven_shading || outcome.uneven_shadow;
  statistics.saturated_pixels += outcome.saturated;
  statistics.unresolved_area += outcome.unresolved_area;
  statistics.pyrays_by_level[static_cast<std::size_t>(max_level)] += sum.samples;
  result.tile.radiance.push_back(sum.mean());
  result.tile.split_level.push_back(static_cast<std::uint8_t>(level));
  const SplitCause cause = cause_of(
      {outcome, trace.by_samples || sum.cut_out, sum.shadow_cut, sum.mirror_cut, sum.defocused});
  result.tile.cause.push_back(cause);
  statistics.split_pixels += cause != SplitCause::none;
  if (cause != SplitCause::none) ++statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
  result.tile.outlook.push_back(outlook_of(trace.outcome, sum));
  rays.push_back(outcome.probes + sum.rays);
}

// Returns the layers with those of the open regions so far.
std::vector<LayerSum> layers_so_far(const StartedPyray& pyray) {
  std::vector<LayerSum> layers = pyray.layers;
  for (std::size_t i = 0; i < pyray.open.parts.size(); ++i) {
    const OpenRegions::Part& part = pyray.open.parts[i];
    layers[pyray.pixel_of_root[part.leaf.root]].add(pyray.open.samples.layers(i), part.leaf.weight);
  }
  return layers;
}

void publish_layers(const StartedPyray& pyray, std::span<const RootSum> sums, FinishedTile& tile) {
  if (!pyray.layers.empty() && !pyray.open.parts.empty()) {
    tile.layers = planes_of(layers_so_far(pyray), pyray.asked);
  } else if (!pyray.layers.empty()) {
    tile.layers = planes_of(pyray.layers, pyray.asked);
  } else {
    tile.layers = blank_planes(pyray.asked, pyray.pixels.size());
  }
  for (LayerPlane& plane : tile.layers) {
    if (plane.layer != Layer::error) continue;
    for (std::size_t i = 0; i < sums.size(); ++i)
      plane.values[i] = static_cast<float>(error_estimate(sums[i], pyray.tolerance));
  }
}

}  // namespace

BlockResult StartedPyray::result(int max_level) const {
  std::vector<RootSum> sums;
  sums.reserve(pixels.size());
  for (const Pixel& pixel : pixels) sums.push_back(pixel.sum);
  for (const OpenRegions::Part& part : open.parts)
    sums[pixel_of_root[part.leaf.root]].add_samples(part.so_far, part.leaf);
  BlockResult result;
  result.tile.rect = block;
  result.statistics = statistics;
  std::vector<std::uint64_t> rays;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    publish_pixel(pixels[i].trace, sums[i], max_level, result, rays);
  publish_rays(rays, result);
  publish_layers(*this, sums, result.tile);
  return result;
}

double StartedPyray::squared_error() const {
  double sum = 0.0;
  for (const OpenRegions::Part& part : open.parts) {
    const double off = part.leaf.weight * part.so_far.error;
    sum += off * off;
  }
  return sum;
}

std::size_t StartedPyray::bytes() const {
  return sizeof(*this) + pixels.size() * sizeof(Pixel) + layers.size() * sizeof(LayerSum) +
         pixel_of_root.size() * sizeof(std::uint32_t) + open.bytes() +
         statistics.lights.size() * sizeof(LightStatistics);
}

}  // namespace asos
