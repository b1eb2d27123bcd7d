#include "renderer/lights/emitter_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asos {
namespace {

// A region's triangles face the same way within half a degree. Their corners lie within
// `flatness_of_emitters` of the plane of the region's largest triangle.
constexpr double least_cosine = 0.99996;
// Largest distance of positions in single precision from their plane by rounding, relative to the
// coordinates.
constexpr double rounding = 4.0 * std::numeric_limits<float>::epsilon();

struct Edge {
  std::uint32_t low, high, triangle;
};

double longest_edge(const EmitterTriangle& t) {
  return std::max({glm::distance(t.corner[0], t.corner[1]), glm::distance(t.corner[1], t.corner[2]),
                   glm::distance(t.corner[2], t.corner[0])});
}

double size_of(const EmitterTriangle& t) {
  double size = 0.0;
  for (const glm::dvec3& p : t.corner)
    size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return size;
}

/// The plane of a flat region while it grows.
struct RegionPlane {
  glm::dvec3 point, normal;
  double height, rounding_height;

  explicit RegionPlane(const EmitterTriangle& seed)
      : point(seed.corner[0]),
        normal(seed.normal),
        height(flatness_of_emitters * longest_edge(seed)),
        rounding_height(rounding * size_of(seed)) {}

  [[nodiscard]] bool holds(const EmitterTriangle& t) const {
    const double facing = glm::dot(t.normal, normal);
    if (!(facing > 0.0)) return false;
    // The normal of a sliver consists of rounding errors.
    const double width = 2.0 * t.area / longest_edge(t);
    if (facing < least_cosine && width > 100.0 * rounding_height) return false;
    return std::all_of(t.corner.begin(), t.corner.end(), [&](glm::dvec3 p) {
      return std::abs(glm::dot(p - point, normal)) <= height + rounding_height;
    });
  }
};

/// Returns the triangles that are connected with `first` through neighbours that satisfy `belongs`.
template <typename Belongs>
Piece grow(std::uint32_t first, const EmitterNeighbours& neighbours, std::vector<bool>& taken,
           const Belongs& belongs) {
  taken[first] = true;
  Piece piece{first};
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (const std::uint32_t other : neighbours.of(piece[i])) {
      if (taken[other] || !belongs(other)) continue;
      taken[other] = true;
      piece.push_back(other);
    }
  }
  return piece;
}

}  // namespace

EmitterNeighbours::EmitterNeighbours(std::span<const EmitterTriangle> triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[i].vertex[k];
      const std::uint32_t b = triangles[i].vertex[(k + 1) % 3];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
  });

  // Connect all pairs around an edge. Around an edge with a great many triangles, connect only
  // neighbours.
  constexpr std::size_t most_around_edge = 8;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  open_.assign(triangles.size(), false);
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].low == edges[begin].low &&
           edges[end].high == edges[begin].high)
      ++end;
    if (end - begin == 1) open_[edges[begin].triangle] = true;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t last = end - begin <= most_around_edge ? end : std::min(end, i + 2);
      for (std::size_t k = i + 1; k < last; ++k) {
        pairs.push_back({edges[i].triangle, edges[k].triangle});
        pairs.push_back({edges[k].triangle, edges[i].triangle});
      }
    }
    begin = end;
  }

  std::sort(pairs.begin(), pairs.end());
  first_.assign(triangles.size() + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++first_[from + 1];
    others_.push_back(to);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::vector<Piece> flat_regions(std::span<const EmitterTriangle> triangles,
                                const EmitterNeighbours& neighbours) {
  Piece seeds(triangles.size());
  std::iota(seeds.begin(), seeds.end(), 0u);
  std::stable_sort(seeds.begin(), seeds.end(), [&](std::uint32_t a, std::uint32_t b) {
    return triangles[a].area > triangles[b].area;
  });
  std::vector<Piece> regions;
  std::vector<bool> taken(triangles.size(), false);
  for (const std::uint32_t seed : seeds) {
    if (taken[seed]) continue;
    const RegionPlane plane(triangles[seed]);
    regions.push_back(grow(seed, neighbours, taken,
                           [&](std::uint32_t other) { return plane.holds(triangles[other]); }));
  }
  return regions;
}

std::vector<std::vector<Piece>> connected_pieces(std::span<const EmitterTriangle> triangles,
                                                 const EmitterNeighbours& neighbours) {
  std::vector<std::size_t> piece_of(triangles.size());
  std::vector<bool> taken(triangles.size(), false);
  std::size_t count = 0;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (taken[first]) continue;
    for (const std::uint32_t t : grow(first, neighbours, taken, [](std::uint32_t) { return true; }))
      piece_of[t] = count;
    ++count;
  }
  std::vector<std::vector<Piece>> pieces(count);
  for (Piece& region : flat_regions(triangles, neighbours))
    pieces[piece_of[region.front()]].push_back(std::move(region));
  return pieces;
}

}  // namespace asos
