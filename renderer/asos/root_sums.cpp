#include "renderer/asos/root_sums.h"

#include "renderer/pyray/error_budget.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>

namespace asos {

void BlurredSum::add(const LeafRegion& region, double share, glm::dvec3 radiance, float distance) {
  parts_.push_back({region.square, borders_.size(), region.border.size(), share, radiance});
  borders_.insert(borders_.end(), region.border.begin(), region.border.end());
  nearest_ = std::min(nearest_, distance);
}

glm::vec3 BlurredSum::mean(const BlurByDepth& blur) const {
  const BlurKernel kernel = blur.at(static_cast<double>(nearest_));
  RootSum sum;
  for (const Part& part : parts_) {
    const auto border = std::span(borders_).subspan(part.first_edge, part.edge_count);
    sum.add(part.radiance, part.share * kernel.integral({part.square, border}));
  }
  return sum.mean();
}

void RootSum::add_samples(const RegionSampler::Mean& found, const PyrayLeaf& leaf,
                          double leaf_weight) {
  // Standard deviation of one sample from which a difference is visible: a quarter of the usual.
  constexpr double visible = ErrorBudget::usual_contrast / 4.0;
  const double held = 1.0 - found.masked_share;
  add(found.value, held * leaf_weight);
  if (std::isfinite(found.error))
    squared_error += held * leaf_weight * found.error * (held * leaf_weight * found.error);
  samples += static_cast<std::uint32_t>(found.cost);
  if (!found.one_round && found.error * std::sqrt(found.cost) > visible)
    varied += static_cast<std::uint32_t>(found.cost);
  cut_out |= found.error > 0.0 && leaf.decision.cause == LeafVariation::layers;
}

}  // namespace asos
