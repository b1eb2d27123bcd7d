#include "renderer/pyray/partition.h"

#include "renderer/geometry/cross.h"
#include "renderer/pyray/partition_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asos {
namespace {

// Returns the position along the border, 0 to 4, from the top left corner over the top right one.
double along_border(glm::dvec2 p) {
  if (p.y == 0.0) return p.x;
  if (p.x == 1.0) return 1.0 + p.y;
  if (p.y == 1.0) return 3.0 - p.x;
  return 4.0 - p.y;
}

bool same_side(glm::dvec2 p, glm::dvec2 q) {
  return (p.x == q.x && (p.x == 0.0 || p.x == 1.0)) || (p.y == q.y && (p.y == 0.0 || p.y == 1.0));
}

// Returns whether x / whole lies between 0 and 1, without a division.
bool is_between(double x, double whole) {
  return whole > 0.0 ? x > 0.0 && x < whole : x < 0.0 && x > whole;
}

// Finds connected components of nodes, to distinguish islands from the parts around them. A
// component is the index of its lowest node.
template <typename Edges>
void find_components(const Edges& edges, std::size_t nodes, std::vector<std::uint32_t>& component) {
  component.resize(nodes);
  std::iota(component.begin(), component.end(), 0u);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& e : edges) {
      const std::uint32_t low = std::min(component[e.from], component[e.to]);
      if (component[e.from] == low && component[e.to] == low) continue;
      component[e.from] = component[e.to] = low;
      changed = true;
    }
  }
}

}  // namespace

std::span<const CellPart> CellPartition::cut(const Square& cell, std::span<const Segment> segments,
                                             std::size_t max_parts) {
  cell_ = cell;
  parts_.clear();
  borders_.clear();
  pieces_.clear();
  specks_.clear();
  for (const Segment& s : segments)
    if (!add_piece(s)) return {};
  // Each line across the whole cell adds a part.
  const auto through = std::count_if(pieces_.begin(), pieces_.end(), [](const Piece& piece) {
    return on_border(piece.p) && on_border(piece.q);
  });
  if (static_cast<std::size_t>(through) >= max_parts) return {};
  if (specks_.empty() && pieces_.size() == 1 && on_border(pieces_[0].p) &&
      on_border(pieces_[0].q)) {
    if (!cut_by_one()) parts_.clear();
  } else if (!cut_by_many(max_parts)) {
    parts_.clear();
  }
  return parts_;
}

// Adds the part of a segment inside the cell, in cell units. Returns false if it is not finite.
bool CellPartition::add_piece(const Segment& s) {
  const glm::dvec2 corner(cell_.u, cell_.v);
  const double scale = 1.0 / static_cast<double>(cell_.side);
  const glm::dvec2 p = (glm::dvec2(s.u0, s.v0) - corner) * scale;
  const glm::dvec2 d = (glm::dvec2(s.u1, s.v1) - corner) * scale - p;
  if (!std::isfinite(p.x + p.y + d.x + d.y)) return false;
  // Clip the segment to the cell.
  const SegmentPart<double> part = clip_segment<double>(p, d, glm::dvec2(0.0), glm::dvec2(1.0));
  if (part.empty()) return true;
  // A piece along a side cuts nothing off; a very short one is no boundary.
  const Piece piece{snapped(p + part.t0 * d), snapped(p + part.t1 * d)};
  if (same_side(piece.p, piece.q)) return true;
  if (glm::distance(piece.p, piece.q) < snap) {
    add_speck(piece.p);
    return true;
  }
  // Edges that coincide in the picture (a face seen edge-on) are one line.
  for (const Piece& other : pieces_) {
    if ((are_one(piece.p, other.p) && are_one(piece.q, other.q)) ||
        (are_one(piece.p, other.q) && are_one(piece.q, other.p)))
      return true;
  }
  pieces_.push_back(piece);
  return true;
}

void CellPartition::add_speck(glm::dvec2 p) {
  const auto known = [&](glm::dvec2 q) { return glm::distance(p, q) < snap; };
  if (std::none_of(specks_.begin(), specks_.end(), known)) specks_.push_back(p);
}

// One line across the cell makes two convex parts.
bool CellPartition::cut_by_one() {
  const Piece piece = pieces_[0];
  const double tp = along_border(piece.p);
  const double tq = along_border(piece.q);
  static constexpr glm::dvec2 corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int part = 0; part < 2; ++part) {
    // Walk around the border from one end to the other, then back along the line.
    const double from = part == 0 ? tp : tq;
    double to = part == 0 ? tq : tp;
    if (to <= from) to += 4.0;
    const glm::dvec2 start = part == 0 ? piece.p : piece.q;
    glm::dvec2 polygon[6] = {start};
    int n = 1;
    for (int c = static_cast<int>(std::floor(from)) + 1; c < to; ++c) polygon[n++] = corners[c % 4];
    polygon[n++] = part == 0 ? piece.q : piece.p;
    // Sum up the area and the centroid, triangle by triangle.
    double area = 0.0;
    glm::dvec2 centroid(0.0), lo(1.0), hi(0.0);
    const std::size_t first_edge = borders_.size();
    for (int i = 0; i < n; ++i) {
      emit_edge(polygon[i], polygon[(i + 1) % n]);
      lo = glm::min(lo, polygon[i]);
      hi = glm::max(hi, polygon[i]);
      if (i < 1 || i + 1 >= n) continue;
      const double a = 0.5 * cross(polygon[i] - start, polygon[i + 1] - start);
      area += a;
      centroid += a * (start + polygon[i] + polygon[i + 1]) / 3.0;
    }
    if (area > 0.0) emit(area, centroid / area, lo, hi, first_edge);
  }
  return !parts_.empty();
}

bool CellPartition::cut_by_many(std::size_t max_parts) {
  split_pieces();
  if (close_gaps(pieces_, nodes_, edges_)) split_pieces();
  add_border();
  return trace_loops(max_parts) && make_parts(max_parts);
}

std::uint32_t CellPartition::node_at(glm::dvec2 p) {
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (are_one(nodes_[i], p)) return i;
  nodes_.push_back(p);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void CellPartition::add_edge(std::uint32_t a, std::uint32_t b) {
  if (a == b) return;
  for (const Edge& e : edges_)
    if ((e.from == a && e.to == b) || (e.from == b && e.to == a)) return;
  edges_.push_back({a, b});
}

// Makes nodes of all ends and crossings, and edges between neighbouring nodes of each piece.
void CellPartition::split_pieces() {
  nodes_.assign({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  edges_.clear();
  // Make nodes of the ends.
  for (const Piece& piece : pieces_) {
    (void)node_at(piece.p);
    (void)node_at(piece.q);
  }
  // Make nodes of the crossings.
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
      const glm::dvec2 d = pieces_[i].q - pieces_[i].p;
      const glm::dvec2 e = pieces_[j].q - pieces_[j].p;
      const glm::dvec2 between = pieces_[j].p - pieces_[i].p;
      const double det = cross(d, e);
      const double along_d = cross(between, e), along_e = cross(between, d);
      if (is_between(along_d, det) && is_between(along_e, det))
        (void)node_at(snapped(pieces_[i].p + (along_d / det) * d));
    }
  }
  // Connect the nodes along each piece, in their order.
  for (const Piece& piece : pieces_) {
    const glm::dvec2 d = piece.q - piece.p;
    const double length = glm::length(d);
    const double far = 3.0 * snap * length;
    order_.clear();
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const glm::dvec2 to = nodes_[i] - piece.p;
      const double area = std::abs(cross(d, to));
      if (area > far) continue;
      const double t = glm::dot(to, d) / (length * length);
      const double away = area / length;
      if (away < 2.0 * snap && t > -2.0 * snap / length && t < 1.0 + 2.0 * snap / length)
        order_.emplace_back(t, i);
    }
    std::sort(order_.begin(), order_.end());
    for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
      const std::uint32_t a = order_[k].second;
      const std::uint32_t b = order_[k + 1].second;
      if (!same_side(nodes_[a], nodes_[b])) add_edge(a, b);
    }
  }
}

void CellPartition::add_border() {
  order_.clear();
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (on_border(nodes_[i])) order_.emplace_back(along_border(nodes_[i]), i);
  std::sort(order_.begin(), order_.end());
  for (std::size_t k = 0; k < order_.size(); ++k)
    add_edge(order_[k].second, order_[(k + 1) % order_.size()].second);
}

// Walks around all parts: half-edge 2e runs from edge e's `from` to its `to`, 2e + 1 back.
bool CellPartition::trace_loops(std::size_t max_parts) {
  const std::size_t count = 2 * edges_.size();
  const auto tail = [&](std::size_t h) { return h & 1 ? edges_[h / 2].to : edges_[h / 2].from; };
  const auto head = [&](std::size_t h) { return tail(h ^ 1); };

  find_components(edges_, nodes_.size(), component_);
  // Euler: bounded parts = edges - nodes + components.
  std::size_t components = 0;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) components += component_[n] == n;
  if (edges_.size() + components > nodes_.size() + max_parts) return false;

  // Sort the half-edges around each node by angle; the successor of h is the predecessor of its
  // twin there. One sort by (node, angle) does this. A monotonic number from 0 to 4 replaces the
  // angle.
  around_.clear();
  for (std::uint32_t h = 0; h < count; ++h) {
    const glm::dvec2 d = nodes_[head(h)] - nodes_[tail(h)];
    const double slope = d.y / (std::abs(d.x) + std::abs(d.y));
    around_.push_back({tail(h), d.x < 0.0 ? 2.0 - slope : slope < 0.0 ? 4.0 + slope : slope, h});
  }
  std::sort(around_.begin(), around_.end(), [](const Spoke& x, const Spoke& y) {
    return x.node != y.node ? x.node < y.node : x.angle < y.angle;
  });
  next_.resize(count);
  for (std::size_t k = 0; k < count;) {
    std::size_t end = k;
    while (end < count && around_[end].node == around_[k].node) ++end;
    for (std::size_t i = k; i < end; ++i)
      next_[around_[i].half_edge ^ 1u] = around_[i == k ? end - 1 : i - 1].half_edge;
    k = end;
  }

  loops_.clear();
  loop_nodes_.clear();
  visited_.assign(count, 0);
  for (std::size_t start = 0; start < count; ++start) {
    if (visited_[start]) continue;
    Loop loop;
    loop.first = static_cast<std::uint32_t>(loop_nodes_.size());
    loop.component = component_[tail(start)];
    for (std::size_t h = start; !visited_[h]; h = next_[h]) {
      visited_[h] = 1;
      loop_nodes_.push_back(tail(h));
      loop.area += 0.5 * cross(nodes_[tail(h)], nodes_[head(h)]);
    }
    loop.count = static_cast<std::uint32_t>(loop_nodes_.size()) - loop.first;
    loops_.push_back(loop);
  }
  return true;
}

// Makes faces from loops: each loop of positive area, less the islands inside it.
bool CellPartition::make_parts(std::size_t max_parts) {
  std::int32_t parts = 0;
  for (Loop& loop : loops_)
    if (loop.area > 0.0) loop.part = parts++;
  if (parts == 0 || static_cast<std::size_t>(parts) > max_parts) return false;
  for (Loop& island : loops_) {
    if (island.area > 0.0 || island.component == component_[0]) continue;
    const glm::dvec2 p = nodes_[loop_nodes_[island.first]];
    double smallest = 2.0;
    for (const Loop& loop : loops_) {
      if (loop.area <= 0.0 || loop.component == island.component || loop.area >= smallest) continue;
      if (!inside(loop, p)) continue;
      smallest = loop.area;
      island.part = loop.part;
    }
    if (island.part < 0) return false;
  }
  for (const Loop& loop : loops_) {
    if (loop.area <= 0.0) continue;
    if (!place_sample(loop.part, loop)) return false;
  }
  double total = 0.0;
  for (const CellPart& part : parts_) total += part.area;
  return std::abs(total - 1.0) < 1e-5;
}

bool CellPartition::inside(const Loop& loop, glm::dvec2 p) const {
  bool in = false;
  for_each_edge(loop, [&](glm::dvec2 a, glm::dvec2 b) {
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
  });
  return in;
}

}  // namespace asos
