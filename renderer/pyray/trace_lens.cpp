#include "renderer/pyray/tracer.h"

#include <algorithm>
#include <span>
#include <vector>

// Finishes the roots of a fat pyray whose camera has a lens.

namespace asos {

// Sharp roots are subdivided as a pinhole's are, smooth ones are one wide leaf each, and all others
// are sampled over the lens. Alternatively all are widened and subdivided.
void Tracer::finish_lens_roots(const FatPyray& fat, const SubdivisionRules& rules, Caster& caster,
                               LensCaster& lens, std::uint32_t observed, TracedPyray* traced) {
  roots_.clear();
  crossed_.clear();
  lens_lists_.resize(std::max(lens_lists_.size(), static_cast<std::size_t>(fat.side * fat.side)));
  for (int y = 0; y < fat.rows; ++y) {
    for (int x = 0; x < fat.columns; ++x) {
      const std::uint32_t i = fat.index(x, y);
      Root root{fat.square_of(x, y, 1), {}, i, i, fat.seed_of(x, y), nullptr};
      if (i == observed) root.traced = traced;
      finish_lens_root(root, caster, lens, rules.error_budget.max_level);
    }
  }
  drop_blurred_roots(rules, lens);
  const auto done = subdivider_.run(search_, roots_, rules, caster);
  for (std::size_t k = 0; k < done.size(); ++k) traces_[roots_[k].id].outcome = done[k];
}

void Tracer::finish_lens_root(Root root, Caster& caster, LensCaster& lens, int max_level) {
  const std::uint32_t i = root.id;
  const bool bounded = fat_search_.bounded(i);
  switch (lens.way(i, bounded, traces_[i].by_samples)) {
    case LensEstimator::sampled:
      return sample_lens_root(root, lens);
    case LensEstimator::smooth:
      if (!lens.shade_smooth(i)) return sample_lens_root(root, lens);
      if (root.traced)
        root.traced->cells.emplace_back().samples.push_back({i, glm::vec2(0.5f), 1.0, {}, {}});
      traces_[i].outcome.pyrays_by_level[0] = 1;
      traces_[i].outcome.probes = 1;
      return;
    case LensEstimator::sharp:
      if (bounded && crosses(root, caster)) {
        crossed_.push_back(root);
        crossed_.back().list = lens_lists_[i];
        return;
      }
      break;
    case LensEstimator::widened:
      root.square = lens.widened_square(i);
      if (bounded && crosses(root, caster)) {
        root.list = lens_lists_[i];
        roots_.push_back(root);
        return;
      }
      break;
  }
  if (!finish_clear_root(root, max_level, caster)) roots_.push_back(root);
}

// Returns whether a boundary that may be visible crosses a root, from the list of its search
// square. `lens_lists_` has the root's own list then.
bool Tracer::crosses(const Root& root, const Caster& caster) {
  BoundarySearch::List& list = lens_lists_[root.id];
  const BoundarySearch::Sight sight = search_.sight(root.square, caster.cover(root.id));
  search_.refine(root.square, sight, fat_search_.list(root.id), list, true);
  return !search_.all_hidden(list, sight);
}

void Tracer::sample_lens_root(const Root& root, LensCaster& lens) {
  lens.sample_root(root.id);
  Trace& trace = traces_[root.id];
  trace.outcome.pyrays_by_level[0] = 1;
  trace.outcome.probes = 1;
  if (!root.traced) return;
  TracedCell& cell = root.traced->cells.emplace_back();
  cell.fate = CellFate::sampled;
  cell.samples.push_back({root.id, glm::vec2(0.5f), 1.0, {}, {}});
}

// The surface behind a boundary may lie at a depth that is not sharp. Such roots are sampled.
void Tracer::drop_blurred_roots(const SubdivisionRules& rules, LensCaster& lens) {
  if (crossed_.empty()) return;
  std::vector<Root> tried = crossed_;
  for (Root& root : tried) root.traced = nullptr;
  (void)subdivider_.run(search_, tried, rules, lens.trial());
  for (const Root& root : crossed_) {
    if (lens.stayed_sharp(root.id))
      roots_.push_back(root);
    else
      sample_lens_root(root, lens);
  }
}

}  // namespace asos
