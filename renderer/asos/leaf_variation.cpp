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

// The samples of leaves of the weights w, whose values scatter by s about a plane through them, are
// off by s sqrt(sum w^2) together.
bool LeafVariation::uneven(std::span<const std::uint32_t> group, double tolerance) const {
  constexpr std::size_t of_plane = 3;  // values that a plane meets whatever they are
  if (group.size() <= of_plane) return false;
  // Find the middle.
  const auto shown = [&](std::uint32_t i) {
    return displayed_intensity(glm::dvec3(leaves_[i].shading), judged_tone_);
  };
  double weight = 0.0, weight2 = 0.0;
  glm::dvec2 middle(0.0);
  glm::dvec3 mean(0.0);
  for (const std::uint32_t i : group) {
    const double w = leaves_[i].leaf.weight;
    weight += w;
    weight2 += w * w;
    middle += w * glm::dvec2(leaves_[i].at);
    mean += w * shown(i);
  }
  middle /= weight;
  mean /= weight;
  // Fit the plane by least squares.
  double xx = 0.0, xy = 0.0, yy = 0.0;
  glm::dvec3 along_x(0.0), along_y(0.0), variance(0.0);
  for (const std::uint32_t i : group) {
    const double w = leaves_[i].leaf.weight / weight;
    const glm::dvec2 d = glm::dvec2(leaves_[i].at) - middle;
    const glm::dvec3 off = shown(i) - mean;
    xx += w * d.x * d.x;
    xy += w * d.x * d.y;
    yy += w * d.y * d.y;
    along_x += w * d.x * off;
    along_y += w * d.y * off;
    variance += w * off * off;
  }
  const double det = xx * yy - xy * xy;
  if (det > 1e-6 * xx * yy) {
    const glm::dvec3 slope_x = (yy * along_x - xy * along_y) / det;
    const glm::dvec3 slope_y = (xx * along_y - xy * along_x) / det;
    variance -= slope_x * along_x + slope_y * along_y;
  }
  // What is left is of so many values fewer.
  const auto count = static_cast<double>(group.size());
  const double left = std::max({0.0, variance.x, variance.y, variance.z}) * count /
                      (count - static_cast<double>(of_plane));
  return std::sqrt(left * weight2) > tolerance;
}

}  // namespace asos
