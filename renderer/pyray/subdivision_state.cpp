#include "renderer/pyray/subdivision_state.h"

#include <algorithm>

namespace asos {

std::vector<BorderEdge> Root::placed_border(const LeafRegion& region) const {
  std::vector<BorderEdge> sides;
  for (const BorderEdge& side : region.border) sides.push_back({place(side.from), place(side.to)});
  if (!sides.empty()) return sides;
  const Square& s = region.square;
  const glm::vec2 corners[4] = {
      {s.u, s.v}, {s.u + s.side, s.v}, {s.u + s.side, s.v + s.side}, {s.u, s.v + s.side}};
  for (std::size_t i = 0; i < 4; ++i)
    sides.push_back({place(corners[i]), place(corners[(i + 1) % 4])});
  return sides;
}

double SubdivisionState::weight(const Cell& cell) const {
  const double side =
      static_cast<double>(cell.square.side) / static_cast<double>(root(cell).square.side);
  return side * side;
}

glm::vec2 SubdivisionState::jittered(std::uint32_t root, const Square& square) const {
  const Root& r = roots[root];
  const auto x = static_cast<std::uint64_t>((square.u - r.square.u) / r.square.side * 65536.0f);
  const auto y = static_cast<std::uint64_t>((square.v - r.square.v) / r.square.side * 65536.0f);
  std::uint64_t h = r.seed ^ (x << 40) ^ (y << 8);
  const auto next = [&h] {
    h += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = h;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
  };
  const float du = next();
  const float dv = next();
  return {square.u + square.side * du, square.v + square.side * dv};
}

void SubdivisionState::add_leaf(const Cell& cell, const PyrayLeaf& leaf) {
  outcome(cell).note_uneven(leaf.decision.cause);
  leaves.push_back(leaf);
}

void SubdivisionState::hand_out() {
  if (!leaves.empty()) caster->take(leaves);
  leaves.clear();
}

TracedCell* SubdivisionState::trace(const CellLevel& level, const Cell& cell, CellFate fate,
                                    std::span<const std::uint32_t> visible) const {
  const Root& root = roots[cell.root];
  if (!root.traced) return nullptr;
  TracedCell& traced = root.traced->cells.emplace_back();
  traced.level = level.number;
  traced.corner = root.place({cell.square.u, cell.square.v});
  traced.side = cell.square.side / root.square.side;
  traced.fate = fate;
  traced.hidden = cell.count - std::min(static_cast<std::uint32_t>(visible.size()), cell.count);
  // Clip the visible boundaries to the reach of the detection.
  const Square reach = sight(cell).reach;
  const HitLists& lists = search->lists();
  for (const std::uint32_t i : visible) {
    if (!lists.entry(i).is_segment()) {
      ++traced.clusters;
      continue;
    }
    const Segment& s = lists.segment(i);
    const SegmentPart<float> c = clip(s, reach);
    if (c.empty()) continue;
    const auto at = [&](float t) {
      return root.place({s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0)});
    };
    traced.boundaries.push_back({at(c.t0), at(c.t1), lists.feature(i)});
  }
  return &traced;
}

}  // namespace asos
