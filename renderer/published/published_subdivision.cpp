#include "renderer/published/published_subdivision.h"

#include "renderer/published/cone_detection.h"

#include <algorithm>
#include <cmath>

namespace asos {

std::unique_ptr<const DetectionTest> PublishedSubdivision::detection(const Frame& frame) const {
  if (detection_ == Detection::square) return nullptr;
  return std::make_unique<ConeDetection>(frame);
}

bool PublishedSubdivision::ends(const LevelStatistics& tally, double eps) const {
  const bool by_object = rule_ == StoppingRule::published;
  return (by_object ? tally.largest_change() : tally.unresolved_area()) <= eps;
}

int one_edge_level_bound(double eps) {
  return std::max(0, static_cast<int>(std::ceil(std::log2(1.0 / eps) - 1.0)));
}

}  // namespace asos
