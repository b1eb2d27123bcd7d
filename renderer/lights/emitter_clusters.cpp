#include "renderer/lights/emitter_clusters.h"

#include <algorithm>
#include <limits>

namespace asos {
namespace {

constexpr int lloyd_rounds = 8;

double distance2(const ClusterPoint& a, const ClusterPoint& b) {
  const glm::dvec3 d = a.position - b.position;
  const glm::dvec3 n = a.facing - b.facing;
  const glm::dvec3 e = a.emission - b.emission;
  return glm::dot(d, d) + glm::dot(n, n) + glm::dot(e, e);
}

/// Returns seeds for k-means; the first is the heaviest point.
std::vector<ClusterPoint> seeds_of(std::span<const ClusterPoint> points, std::size_t most,
                                   double tolerance) {
  const auto lighter = [](const ClusterPoint& a, const ClusterPoint& b) {
    return a.weight < b.weight;
  };
  std::vector<ClusterPoint> seeds{*std::max_element(points.begin(), points.end(), lighter)};
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  while (seeds.size() < most) {
    for (std::size_t i = 0; i < points.size(); ++i)
      nearest[i] = std::min(nearest[i], distance2(points[i], seeds.back()));
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    if (!(*farthest > tolerance * tolerance)) break;
    seeds.push_back(points[static_cast<std::size_t>(farthest - nearest.begin())]);
  }
  return seeds;
}

std::vector<std::vector<std::uint32_t>> nearest_groups(std::span<const ClusterPoint> points,
                                                       const std::vector<ClusterPoint>& middles) {
  std::vector<std::vector<std::uint32_t>> groups(middles.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < middles.size(); ++k) {
      if (distance2(points[i], middles[k]) < distance2(points[i], middles[best])) best = k;
    }
    groups[best].push_back(i);
  }
  return groups;
}

ClusterPoint middle_of(std::span<const ClusterPoint> points,
                       const std::vector<std::uint32_t>& group) {
  ClusterPoint sum{glm::dvec3(0.0), glm::dvec3(0.0), 0.0, glm::dvec3(0.0)};
  for (const std::uint32_t i : group) {
    sum.position += points[i].weight * points[i].position;
    sum.facing += points[i].weight * points[i].facing;
    sum.emission += points[i].weight * points[i].emission;
    sum.weight += points[i].weight;
  }
  return {sum.position / sum.weight, sum.facing / sum.weight, sum.weight,
          sum.emission / sum.weight};
}

}  // namespace

std::vector<std::vector<std::uint32_t>> cluster(std::span<const ClusterPoint> points,
                                                std::size_t most, double tolerance) {
  if (points.empty() || most == 0) return {};
  std::vector<ClusterPoint> middles = seeds_of(points, most, tolerance);
  std::vector<std::vector<std::uint32_t>> groups = nearest_groups(points, middles);
  for (int round = 0; round < lloyd_rounds && middles.size() > 1; ++round) {
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (!groups[k].empty()) middles[k] = middle_of(points, groups[k]);
    }
    groups = nearest_groups(points, middles);
  }
  std::erase_if(groups, [](const std::vector<std::uint32_t>& group) { return group.empty(); });
  return groups;
}

}  // namespace asos
