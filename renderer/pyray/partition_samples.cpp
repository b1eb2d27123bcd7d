#include "renderer/geometry/cross.h"
#include "renderer/pyray/partition.h"

#include <algorithm>
#include <cmath>

// Places the samples of a cell's parts.

namespace asos {
namespace {

// Distance of a sample from its part's border, in square roots of the part's area. Simplified
// chains are within 1/64 of a cell of their true place.
constexpr double well_inside = 1.0 / 32.0;

}  // namespace

bool CellPartition::inside_part(std::int32_t part, glm::dvec2 p) const {
  bool in = false;
  for (const Loop& loop : loops_)
    if (loop.part == part && inside(loop, p)) in = !in;
  return in;
}

// Computes a part's area and the place of its sample: the centroid if it is well inside, since
// boundaries may be slightly displaced, else the place farthest from the border among the centroid
// and the centres of a few chords.
bool CellPartition::place_sample(std::int32_t part, const Loop& outer) {
  // Sum up the area, the centroid and the bounds.
  double area = 0.0;
  glm::dvec2 centroid(0.0), lo(1.0), hi(0.0);
  const std::size_t first_edge = borders_.size();
  bool simple = true;
  for (const Loop& loop : loops_) {
    if (loop.part != part) continue;
    simple &= loop.area > 0.0;
    area += loop.area;
    for_each_edge(loop, [&](glm::dvec2 a, glm::dvec2 b) {
      centroid += cross(a, b) * (a + b) / 6.0;
      emit_edge(a, b);
    });
  }
  for_each_edge(outer, [&](glm::dvec2 a, glm::dvec2) {
    lo = glm::min(lo, a);
    hi = glm::max(hi, a);
  });
  if (area < 1e-12) return true;
  centroid /= area;
  if (simple && specks_.empty() && outer.count <= 3) {
    emit(area, centroid, lo, hi, first_edge);
    return true;
  }
  double clearest = inside_part(part, centroid) ? clearance(part, centroid) : 0.0;
  glm::dvec2 best = centroid;
  const double enough = well_inside * std::min(1.0, std::sqrt(area));
  for (const double f : {0.5, 0.25, 0.75, 0.1, 0.9}) {
    if (clearest >= enough) break;
    find_crossings(part, lo.y + f * (hi.y - lo.y));
    for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
      const glm::dvec2 middle(0.5 * (crossings_[k] + crossings_[k + 1]), lo.y + f * (hi.y - lo.y));
      const double clear = crossings_[k + 1] > crossings_[k] ? clearance(part, middle) : 0.0;
      if (clear > clearest) clearest = clear, best = middle;
    }
  }
  if (clearest <= 0.0) return false;
  emit(area, best, lo, hi, first_edge);
  return true;
}

// Finds where a part's border crosses the line at height y, in order.
void CellPartition::find_crossings(std::int32_t part, double y) {
  crossings_.clear();
  for (const Loop& loop : loops_) {
    if (loop.part != part) continue;
    for_each_edge(loop, [&](glm::dvec2 a, glm::dvec2 b) {
      if ((a.y > y) != (b.y > y)) crossings_.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    });
  }
  std::sort(crossings_.begin(), crossings_.end());
}

// Returns the distance of a point from its part's border and from specks; the cell's own border
// counts as well.
double CellPartition::clearance(std::int32_t part, glm::dvec2 p) const {
  double nearest = 2.0;
  for (const Loop& loop : loops_) {
    if (loop.part != part) continue;
    for_each_edge(loop, [&](glm::dvec2 a, glm::dvec2 b) {
      const glm::dvec2 d = b - a;
      const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(p, a + t * d));
    });
  }
  for (const glm::dvec2 speck : specks_) nearest = std::min(nearest, glm::distance(p, speck));
  return nearest;
}

void CellPartition::emit_edge(glm::dvec2 from, glm::dvec2 to) {
  const auto placed = [&](glm::dvec2 p) {
    return glm::vec2(cell_.u, cell_.v) + cell_.side * glm::vec2(p);
  };
  borders_.push_back({placed(from), placed(to)});
}

// The part's edges are those from `first_edge` on.
void CellPartition::emit(double area, glm::dvec2 at, glm::dvec2 lo, glm::dvec2 hi,
                         std::size_t first_edge) {
  const auto u = [&](double x) { return cell_.u + cell_.side * static_cast<float>(x); };
  const auto v = [&](double y) { return cell_.v + cell_.side * static_cast<float>(y); };
  parts_.push_back({area, u(at.x), v(at.y), u(lo.x), v(lo.y), u(hi.x), v(hi.y),
                    static_cast<std::uint32_t>(first_edge),
                    static_cast<std::uint32_t>(borders_.size() - first_edge)});
}

}  // namespace asos
