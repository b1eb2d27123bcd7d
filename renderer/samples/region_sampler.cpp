#include "renderer/samples/region_sampler.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

constexpr std::uint32_t per_sum = 1;

}  // namespace

RegionSampler::RegionSampler(const RenderScene& scene, const Viewer& viewer,
                             const RenderSettings& settings, PixelRect block, int seed,
                             const MirroredMask* mask)
    : block_(block),
      mask_(mask),
      white_(1.0 / std::clamp(static_cast<double>(viewer.throughput), 1e-3, 1.0)),
      places_(seed),
      sums_(scene, viewer, settings, places_) {}

RegionSampler::Estimate RegionSampler::sample(const LeafRegion& region, const Goal& goal,
                                              RenderStatistics& counts, const BlurKernel* kernel) {
  sums_.resize(0);
  Share all;
  Estimate found;
  std::uint32_t first = 0;
  for (std::uint32_t end = goal.least; end <= goal.most; end *= 2) {
    const Share round = add(region, kernel, first, end);
    all.in_region += round.in_region;
    all.masked += round.masked;
    first = end;
    found = estimate(end);
    if (found.samples > 0 && standard_error(end, found.mean) <= goal.standard_error) break;
  }
  if (all.in_region > 0) found.masked_share = static_cast<double>(all.masked) / all.in_region;
  counts += sums_.statistics();
  sums_.statistics() = {};
  return found;
}

RegionSampler::Share RegionSampler::add(const LeafRegion& region, const BlurKernel* kernel,
                                        std::uint32_t first, std::uint32_t end) {
  Share share;
  const Bounds2 bounds = bounds_of(region);
  const double width = static_cast<double>(block_.width);
  const glm::dvec2 origin(block_.x, block_.y);
  const auto x = static_cast<int>(std::floor(origin.x + width * region.square.u));
  const auto y = static_cast<int>(std::floor(origin.y + width * region.square.v));
  const glm::vec2 size = (bounds.hi - bounds.lo) * static_cast<float>(width);
  const float side = std::sqrt(size.x * size.y / static_cast<float>(end));
  sums_.resize(end / per_sum);
  places_.start_pixel(x, y);
  for (std::uint32_t i = first; i < end; ++i) {
    places_.start_sample(static_cast<int>(i));
    const PixelPoint p = places_.in_pixel();
    glm::vec2 at = glm::mix(bounds.lo, bounds.hi, glm::vec2(p.x, p.y));
    if (!region.holds(at)) continue;
    ++share.in_region;
    if (kernel && region.border.empty()) at = kernel->warped(at, region.square);
    if (mask_ && !mask_->holds(at)) {
      ++share.masked;
      continue;
    }
    if (sums_.add({origin + width * glm::dvec2(at), side, x, y, static_cast<int>(i), i / per_sum}))
      places_.start_pixel(x, y);
  }
  sums_.trace();
  return share;
}

RegionSampler::Estimate RegionSampler::estimate(std::uint32_t count) const {
  Estimate all;
  for (std::uint32_t k = 0; k < count / per_sum; ++k) {
    const SampleSums::Sum sum = sums_.sum(k);
    all.mean += sum.radiance;
    all.samples += sum.count;
  }
  if (all.samples > 0) all.mean /= static_cast<double>(all.samples);
  return all;
}

// By the quarters of the samples so far, each of which is as well distributed as its size allows.
double RegionSampler::standard_error(std::uint32_t count, glm::dvec3 mean) const {
  const std::uint32_t sums = count / per_sum;
  double squares = 0.0;
  for (std::uint32_t q = 0; q < 4; ++q) {
    SampleSums::Sum quarter;
    for (std::uint32_t k = q * sums / 4; k < (q + 1) * sums / 4; ++k) {
      quarter.radiance += sums_.sum(k).radiance;
      quarter.count += sums_.sum(k).count;
    }
    if (quarter.count == 0) continue;
    const glm::dvec3 off = glm::abs(quarter.mean() - mean);
    const double most = std::min(white_, std::max({off.x, off.y, off.z}));
    squares += most * most;
  }
  return std::sqrt(squares / 12.0);
}

}  // namespace asos
