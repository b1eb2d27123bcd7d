#include "renderer/geometry/cross.h"
#include "renderer/pyray/partition.h"
#include "renderer/pyray/partition_points.h"

#include <algorithm>
#include <utility>

// How lines that end a little before the next one go on to it.

namespace asos {
namespace {

// So little, in cells: what a line is misplaced by where it goes on.
constexpr double widest_gap = 1.0 / 64.0;

}  // namespace

// Joins the pieces that end by a little before another to it, by pieces of their own: no line is
// moved. Whether there were any.
bool CellPartition::close_gaps() {
  const std::size_t count = pieces_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [p, q] = pieces_[i];
    const glm::dvec2 along = glm::normalize(q - p);
    for (const auto& [end, ahead] : {std::pair(p, -along), std::pair(q, along)}) {
      if (!dangles(end)) continue;
      if (const auto to = beyond_gap(i, end, ahead)) pieces_.push_back({end, *to});
    }
  }
  return pieces_.size() > count;
}

// Whether a piece's end bounds nothing: no other begins or passes there.
bool CellPartition::dangles(glm::dvec2 end) const {
  if (on_border(end)) return false;
  const auto meets = [&](const Edge& e) {
    return are_one(nodes_[e.from], end) || are_one(nodes_[e.to], end);
  };
  return std::count_if(edges_.begin(), edges_.end(), meets) == 1;
}

// Where a piece goes on to from its end: to the next line ahead, or else to the nearest end of
// another, if that is near enough.
std::optional<glm::dvec2> CellPartition::beyond_gap(std::size_t piece, glm::dvec2 end,
                                                    glm::dvec2 ahead) const {
  double nearest = widest_gap;
  std::optional<glm::dvec2> found;
  const auto offer = [&](glm::dvec2 p, double distance) {
    if (!(distance > snap) || distance > nearest) return;
    nearest = distance;
    found = p;
  };
  // The border.
  for (int k = 0; k < 2; ++k) {
    if (ahead[k] == 0.0) continue;
    const double t = ((ahead[k] > 0.0 ? 1.0 : 0.0) - end[k]) / ahead[k];
    offer(snapped(end + t * ahead), t);
  }
  // Others that cross its way.
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i == piece) continue;
    const glm::dvec2 along = pieces_[i].q - pieces_[i].p;
    const glm::dvec2 between = pieces_[i].p - end;
    const double det = cross(ahead, along);
    const double t = cross(between, along) / det;
    const double s = cross(between, ahead) / det;
    if (s > 0.0 && s < 1.0) offer(end + t * ahead, t);
  }
  if (found) return found;
  // Others that end beside it.
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i == piece) continue;
    for (const glm::dvec2 other : {pieces_[i].p, pieces_[i].q})
      offer(other, glm::distance(other, end));
  }
  return found;
}

}  // namespace asos
