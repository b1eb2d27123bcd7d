#include "renderer/asos/footprint_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace asos {
namespace {

// Computes the area and moments inside a border, relative to a point, so that nothing cancels. Uses
// Green's theorem.
struct Moments {
  double area = 0.0;
  glm::dvec2 first{0.0}, square{0.0};
  double mixed = 0.0;

  void add(glm::dvec2 p, glm::dvec2 q) {
    const double cross = p.x * q.y - q.x * p.y;
    area += cross / 2.0;
    first += cross / 6.0 * (p + q);
    square += cross / 12.0 * (p * p + p * q + q * q);
    mixed += cross / 24.0 * (p.x * q.y + 2.0 * p.x * p.y + 2.0 * q.x * q.y + q.x * p.y);
  }

  // Returns the shape in units of a square's side.
  [[nodiscard]] std::optional<FootprintShape> shape(double side) const {
    const glm::dvec2 mean = first / area;
    const glm::dvec2 variance = square / area - mean * mean;
    const double covariance = mixed / area - mean.x * mean.y;
    // A parallelogram with these edges e and f has the covariance (e e^T + f f^T) / 12.
    const double along = std::sqrt(12.0 * variance.x);
    const double lean = 12.0 * covariance / along;
    const double across = std::sqrt(12.0 * variance.y - lean * lean);
    const bool sound = std::isfinite(mean.x + mean.y) && along > 0.0 && across > 0.0;
    if (!sound) return std::nullopt;
    return FootprintShape{glm::vec2(mean / side), glm::vec2(along / side, lean / side),
                          glm::vec2(0.0, across / side)};
  }
};

// Adds a side clamped to a rectangle: its parts outside follow the rectangle's border, so that
// their areas cancel.
void add_drawn_in(glm::dvec2 p, glm::dvec2 q, glm::dvec2 lo, glm::dvec2 hi, Moments& sum) {
  // Handle sides entirely beyond one side of the rectangle, or entirely inside.
  const glm::dvec2 low = glm::min(p, q), high = glm::max(p, q);
  const bool beyond = low.x >= hi.x || low.y >= hi.y || high.x <= lo.x || high.y <= lo.y;
  if (beyond || (glm::clamp(low, lo, hi) == low && glm::clamp(high, lo, hi) == high)) {
    sum.add(glm::clamp(p, lo, hi), glm::clamp(q, lo, hi));
    return;
  }
  const glm::dvec2 d = q - p;
  // Find where the side crosses the rectangle's four lines.
  std::array<double, 4> at{};
  for (int k = 0; k < 2; ++k) {
    const auto first = static_cast<std::size_t>(2 * k);
    at[first] = d[k] != 0.0 ? std::clamp((lo[k] - p[k]) / d[k], 0.0, 1.0) : 0.0;
    at[first + 1] = d[k] != 0.0 ? std::clamp((hi[k] - p[k]) / d[k], 0.0, 1.0) : 0.0;
  }
  std::sort(at.begin(), at.end());
  glm::dvec2 from = glm::clamp(p, lo, hi);
  const auto go = [&](glm::dvec2 place) {
    const glm::dvec2 to = glm::clamp(place, lo, hi);
    sum.add(from, to);
    from = to;
  };
  for (const double t : at) go(p + t * d);
  go(q);
}

}  // namespace

FootprintShape footprint_shape(const LeafRegion& region, glm::vec2 at) {
  if (region.border.empty()) return {};
  Moments sum;
  for (const BorderEdge& side : region.border)
    sum.add(glm::dvec2(side.from - at), glm::dvec2(side.to - at));
  return sum.shape(std::sqrt(std::abs(sum.area))).value_or(FootprintShape{});
}

void add_footprint_shapes(const LeafRegion& region, glm::vec2 at, int n,
                          std::vector<WeightedShape>& shapes) {
  Moments all;
  for (const BorderEdge& side : region.border)
    all.add(glm::dvec2(side.from - at), glm::dvec2(side.to - at));
  const Bounds2 bounds = bounds_of(region);
  const glm::dvec2 lo(bounds.lo - at), step = glm::dvec2(bounds.hi - bounds.lo) / double(n);
  const double side = std::sqrt(std::abs(all.area));
  double found = 0.0;
  const std::size_t first = shapes.size();
  for (int k = 0; k < n * n; ++k) {
    const glm::dvec2 from = lo + step * glm::dvec2(k % n, k / n);
    Moments part;
    for (const BorderEdge& s : region.border)
      add_drawn_in(glm::dvec2(s.from - at), glm::dvec2(s.to - at), from, from + step, part);
    const double share = part.area / all.area;
    constexpr double next_to_nothing = 1e-3;
    if (!(share > next_to_nothing)) continue;
    const auto shape = part.shape(side);
    if (!shape) continue;
    shapes.push_back({*shape, static_cast<float>(share)});
    found += share;
  }
  for (std::size_t i = first; i < shapes.size(); ++i) shapes[i].share /= static_cast<float>(found);
}

}  // namespace asos
