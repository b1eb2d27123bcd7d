#include "renderer/pyray/safety_net.h"

#include <algorithm>
#include <array>

namespace asos {
namespace {

// A boundary is known to be near, so four samples that agree are not yet believed.
constexpr int first_trusted_level = 2;

struct Splitter {
  std::uint32_t id;
  int max_level;
  Caster& caster;
  SubdivisionOutcome outcome{};

  void split(const Square& square, int level) {
    const double weight = 1.0 / static_cast<double>(1ull << (2 * level));
    outcome.deepest = std::max(outcome.deepest, level);
    outcome.pyrays_by_level.at(static_cast<std::size_t>(level)) += 4;
    std::array<glm::vec2, 4> points;
    for (int i = 0; i < 4; ++i) {
      const Square child = square.quarter(i);
      points[static_cast<std::size_t>(i)] = {child.centre_u(), child.centre_v()};
    }
    const Caster::SampleId first = caster.probe(points);
    bool differ = false;
    for (std::uint32_t i = 1; i < 4; ++i)
      differ |= caster.surface(first + i) != caster.surface(first);
    if ((differ || level < first_trusted_level) && level < max_level) {
      for (int i = 0; i < 4; ++i) split(square.quarter(i), level + 1);
      return;
    }
    if (differ) outcome.unresolved_area += 4.0 * weight;
    for (std::uint32_t i = 0; i < 4; ++i)
      caster.leaf(id, first + i, weight, {square.quarter(static_cast<int>(i)), {}, differ});
  }
};

}  // namespace

SubdivisionOutcome split_by_samples(const Root& root, int max_level, Caster& caster) {
  Splitter splitter{root.id, max_level, caster};
  splitter.outcome.pyrays_by_level[0] = 1;
  if (max_level > 0) {
    splitter.split(root.square, 1);
    return splitter.outcome;
  }
  const glm::vec2 centre(root.square.centre_u(), root.square.centre_v());
  caster.leaf(root.id,
              root.centre != Caster::no_sample ? root.centre : caster.probe(std::span(&centre, 1)),
              1.0, {root.square, {}, true});
  return splitter.outcome;
}

}  // namespace asos
