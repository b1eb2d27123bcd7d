#include "renderer/pyray/partition_pieces.h"

#include "renderer/geometry/cross.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace asos {
namespace {

// Largest gap between the end of a piece and its continuation, in cells.
constexpr double widest_gap = 1.0 / 64.0;

/// The nodes of a cell with their edges.
class Graph {
 public:
  Graph(std::span<const glm::dvec2> nodes, std::span<const PartitionEdge> edges)
      : nodes_(nodes), edges_(edges), edges_at_(nodes.size(), 0) {
    for (const PartitionEdge& e : edges) ++edges_at_[e.from], ++edges_at_[e.to];
  }

  /// Returns whether a piece's end is loose: no other piece begins or passes there.
  [[nodiscard]] bool dangles(glm::dvec2 end) const {
    if (on_border(end)) return false;
    int found = 0, edges = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!are_one(nodes_[i], end)) continue;
      ++found;
      edges = edges_at_[i];
    }
    if (found <= 1) return edges == 1;
    // The end is near both of two nodes; an edge between them counts once.
    const auto meets = [&](const PartitionEdge& e) {
      return are_one(nodes_[e.from], end) || are_one(nodes_[e.to], end);
    };
    return std::count_if(edges_.begin(), edges_.end(), meets) == 1;
  }

 private:
  std::span<const glm::dvec2> nodes_;
  std::span<const PartitionEdge> edges_;
  std::vector<int> edges_at_;
};

// Returns the continuation of a piece beyond its end: the next line ahead, or else the nearest end
// of another, if it is within the limit.
std::optional<glm::dvec2> beyond_gap(std::span<const PartitionPiece> pieces, std::size_t piece,
                                     glm::dvec2 end, glm::dvec2 ahead) {
  double nearest = widest_gap;
  std::optional<glm::dvec2> found;
  const auto offer = [&](glm::dvec2 p, double distance) {
    if (!(distance > snap) || distance > nearest) return;
    nearest = distance;
    found = p;
  };
  // The cell's border.
  for (int k = 0; k < 2; ++k) {
    if (ahead[k] == 0.0) continue;
    const double t = ((ahead[k] > 0.0 ? 1.0 : 0.0) - end[k]) / ahead[k];
    offer(snapped(end + t * ahead), t);
  }
  // Offer the crossings with other pieces.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == piece) continue;
    const glm::dvec2 along = pieces[i].q - pieces[i].p;
    const glm::dvec2 between = pieces[i].p - end;
    const double det = cross(ahead, along);
    const double t = cross(between, along) / det;
    const double s = cross(between, ahead) / det;
    if (s > 0.0 && s < 1.0) offer(end + t * ahead, t);
  }
  if (found) return found;
  // Offer ends of other pieces.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == piece) continue;
    for (const glm::dvec2 other : {pieces[i].p, pieces[i].q})
      offer(other, glm::distance(other, end));
  }
  return found;
}

}  // namespace

bool close_gaps(std::vector<PartitionPiece>& pieces, std::span<const glm::dvec2> nodes,
                std::span<const PartitionEdge> edges) {
  const Graph graph(nodes, edges);
  const std::size_t count = pieces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [p, q] = pieces[i];
    const glm::dvec2 along = glm::normalize(q - p);
    for (const auto& [end, ahead] : {std::pair(p, -along), std::pair(q, along)}) {
      if (!graph.dangles(end)) continue;
      if (const auto to = beyond_gap(pieces, i, end, ahead)) pieces.push_back({end, *to});
    }
  }
  return pieces.size() > count;
}

}  // namespace asos
