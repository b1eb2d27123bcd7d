#include "renderer/asos/root_sums.h"

#include <algorithm>

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

}  // namespace asos
