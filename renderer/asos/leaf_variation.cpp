#include "renderer/asos/leaf_variation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace asos {

void LeafVariation::add(const ShadedLeaf& leaf) {
  leaves_.push_back(leaf);
  first_edge_.push_back(borders_.size());
  borders_.insert(borders_.end(), leaf.leaf.region.border.begin(), leaf.leaf.region.border.end());
}

std::vector<ShadedLeaf> LeafVariation::take_uneven(double tolerance) {
  // Group the leaves by root and surface, in the order of their coming.
  std::vector<std::uint32_t> order(leaves_.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::pair(leaves_[i].leaf.root, leaves_[i].surface);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  // Take the groups that differ.
  std::vector<ShadedLeaf> taken;
  taken_ = std::move(borders_);
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && key(order[end]) == key(order[first])) ++end;
    const auto group = std::span(order).subspan(first, end - first);
    first = end;
    if (!uneven(group, tolerance)) continue;
    for (const std::uint32_t i : group) {
      ShadedLeaf& leaf = taken.emplace_back(leaves_[i]);
      LeafRegion& region = leaf.leaf.region;
      region.border = std::span(taken_).subspan(first_edge_[i], region.border.size());
    }
  }
  leaves_.clear();
  first_edge_.clear();
  borders_.clear();
  return taken;
}

// The samples of leaves of the weights w, whose values scatter by s, are off by s sqrt(sum w^2)
// together.
bool LeafVariation::uneven(std::span<const std::uint32_t> group, double tolerance) const {
  if (group.size() < 2) return false;
  glm::dvec3 sum(0.0), squares(0.0);
  double weight = 0.0, weight2 = 0.0;
  for (const std::uint32_t i : group) {
    const double w = leaves_[i].leaf.weight;
    const glm::dvec3 shown = glm::clamp(glm::dvec3(leaves_[i].shading), 0.0, 1.0);
    sum += w * shown;
    squares += w * shown * shown;
    weight += w;
    weight2 += w * w;
  }
  const glm::dvec3 variance =
      glm::max(glm::dvec3(0.0), squares / weight - (sum / weight) * (sum / weight));
  const double most = std::max({variance.x, variance.y, variance.z});
  return std::sqrt(most * weight2) > tolerance;
}

}  // namespace asos
