#include "renderer/features/deviation.h"

#include "renderer/features/stoppable_loop.h"

#include <atomic>
#include <cmath>
#include <unordered_map>

namespace asos {
namespace {

using FacetBoxes = std::unordered_map<std::uint32_t, Box>;

// Returns the boxes of the facets with more than one triangle.
FacetBoxes boxes_of(const World& world, DisjointSets& facets) {
  FacetBoxes boxes;
  const auto n = static_cast<std::uint32_t>(world.triangles.size());
  for (std::uint32_t t = 0; t < n; ++t)
    if (const std::uint32_t facet = facets.find(t); facet != t) boxes.try_emplace(facet);
  if (boxes.empty()) return boxes;
  for (std::uint32_t t = 0; t < n; ++t) {
    const auto found = boxes.find(facets.find(t));
    if (found == boxes.end()) continue;
    for (int k = 0; k < 3; ++k) found->second.grow(world.positions[world.triangles[t][k]]);
  }
  return boxes;
}

struct Plane {
  glm::dvec3 point;
  glm::dvec3 normal;

  static Plane of(const World& world, std::uint32_t triangle) {
    const glm::uvec3 t = world.triangles[triangle];
    const glm::dvec3 a(world.positions[t.x]);
    return {a, glm::normalize(glm::cross(glm::dvec3(world.positions[t.y]) - a,
                                         glm::dvec3(world.positions[t.z]) - a))};
  }
  [[nodiscard]] double distance(glm::dvec3 p) const {
    return std::abs(glm::dot(normal, p - point));
  }
  [[nodiscard]] double distance(const Box& box) const {
    const glm::dvec3 lo(box.lo), hi(box.hi);
    return distance(0.5 * (lo + hi)) + glm::dot(glm::abs(normal), 0.5 * (hi - lo));
  }
};

// Raises a shared maximum, in any order of threads.
void raise(float& most, float to) {
  std::atomic_ref shared(most);
  float there = shared.load(std::memory_order_relaxed);
  while (there < to && !shared.compare_exchange_weak(there, to, std::memory_order_relaxed)) {
  }
}

}  // namespace

std::vector<float> deviations(const World& world, DisjointSets& facets,
                              std::span<const FeatureEdge> edges, const std::stop_token& stop) {
  std::vector<float> deviation(world.triangles.size());
  const FacetBoxes boxes = boxes_of(world, facets);
  const auto depart = [&](std::uint32_t from, std::uint32_t to, std::uint32_t third) {
    const Plane plane = Plane::of(world, from);
    const auto box = boxes.find(facets.find(to));
    const double d = box == boxes.end() ? plane.distance(glm::dvec3(world.positions[third]))
                                        : plane.distance(box->second);
    // The deviation beyond one edge of a flat facet applies to all its triangles.
    raise(deviation[facets.find(from)], static_cast<float>(d));
  };
  in_parallel(edges.size(), stop, [&](std::uint32_t i) {
    const FeatureEdge& edge = edges[i];
    if (edge.kind != FeatureKind::silhouette) return;
    depart(edge.left_surface, edge.right_surface, edge.right);
    depart(edge.right_surface, edge.left_surface, edge.left);
  });
  // Each facet's value is stored with its lowest triangle, which comes before all others.
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t)
    deviation[t] = deviation[facets.find(t)];
  return deviation;
}

}  // namespace asos
