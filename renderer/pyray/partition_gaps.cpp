#include "renderer/geometry/cross.h"
#include "renderer/pyray/partition.h"
#include "renderer/pyray/partition_points.h"

#include <algorithm>

// How lines that end a little before the next one go on to it.

namespace asos {
namespace {

// So little, in cells: what a line is misplaced by where it goes on.
constexpr double widest_gap = 1.0 / 64.0;

}  // namespace

// Draws out the pieces that end by a little before another. Whether there were any.
bool CellPartition::close_gaps() {
  bool any = false;
  const auto draw_out = [&](std::size_t piece, glm::dvec2& end, glm::dvec2 ahead) {
    if (!dangles(end)) return;
    const auto to = beyond_gap(piece, end, ahead);
    if (to) end = *to;
    any |= to.has_value();
  };
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const glm::dvec2 along = glm::normalize(pieces_[i].q - pieces_[i].p);
    draw_out(i, pieces_[i].p, -along);
    draw_out(i, pieces_[i].q, along);
  }
  return any;
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
