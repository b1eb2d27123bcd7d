#include "renderer/pyray/safety_net.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <array>

namespace asos {
namespace {

struct Splitter {
  const Root& root;
  int max_level;
  Caster& caster;
  SubdivisionOutcome outcome{};
  std::vector<PyrayLeaf> leaves{};

  void split(const Square& square, int level) {
    const double weight = 1.0 / static_cast<double>(1ull << (2 * level));
    outcome.deepest = std::max(outcome.deepest, level);
    outcome.pyrays_by_level.at(static_cast<std::size_t>(level)) += 4;
    // Sample the centres of the four quarters.
    std::array<glm::vec2, 4> points;
    for (int i = 0; i < 4; ++i) {
      const Square child = square.quarter(i);
      points[static_cast<std::size_t>(i)] = {child.centre_u(), child.centre_v()};
    }
    const SampleId first = caster.probe(points);
    outcome.probes += 4;
    bool differ = false;
    for (std::uint32_t i = 1; i < 4; ++i)
      differ |= caster.surface(first + i) != caster.surface(first);
    // Split the quarters if their samples' surfaces differ or the level is low, up to max_level.
    if ((differ || level < SearchTuning::first_trusted_level) && level < max_level) {
      for (int i = 0; i < 4; ++i) split(square.quarter(i), level + 1);
      return;
    }
    // Else make a leaf of each quarter.
    if (differ) outcome.unresolved_area += 4.0 * weight;
    for (std::uint32_t i = 0; i < 4; ++i) {
      PyrayLeaf leaf{root.id, first + i, weight, {square.quarter(static_cast<int>(i)), {}, differ}};
      if (!differ) leaf.decision = caster.decide(leaf, false);
      leaves.push_back(leaf);
    }
  }
};

void trace(const Root& root, std::span<const PyrayLeaf> leaves) {
  if (!root.traced) return;
  TracedCell& cell = root.traced->cells.emplace_back();
  cell.fate = CellFate::by_samples;
  for (const PyrayLeaf& leaf : leaves) {
    const Square& s = leaf.region.square;
    const glm::vec2 at(s.centre_u() - root.square.u, s.centre_v() - root.square.v);
    cell.samples.push_back(
        {leaf.sample, at / root.square.side, leaf.weight, {}, {}, root.placed_border(leaf.region)});
  }
}

}  // namespace

SubdivisionOutcome split_by_samples(const Root& root, int max_level, Caster& caster) {
  Splitter splitter{root, max_level, caster};
  splitter.outcome.pyrays_by_level[0] = 1;
  splitter.outcome.probes = 1;  // at its centre
  if (max_level > 0) {
    splitter.split(root.square, 1);
  } else {
    const glm::vec2 middle(root.square.centre_u(), root.square.centre_v());
    const SampleId sample =
        root.middle != no_sample ? root.middle : caster.probe(std::span(&middle, 1));
    splitter.leaves.push_back({root.id, sample, 1.0, {root.square, {}, true}});
  }
  trace(root, splitter.leaves);
  caster.take(splitter.leaves);
  return splitter.outcome;
}

}  // namespace asos
