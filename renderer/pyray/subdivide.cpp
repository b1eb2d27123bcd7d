#include "renderer/pyray/subdivide.h"

#include <algorithm>
#include <utility>

namespace asos {

std::span<const SubdivisionOutcome> Subdivider::run(BoundarySearch& search,
                                                    std::span<const Root> roots,
                                                    const SubdivisionRules& rules, Caster& caster) {
  state_.search = &search;
  state_.caster = &caster;
  state_.rules = rules;
  state_.roots = roots;
  state_.outcomes.assign(roots.size(), {});
  start(roots);
  CellLevel* current = &levels_[0];
  CellLevel* next = &levels_[1];
  for (int number = 0; !current->cells.empty() && !caster.cancelled(); ++number) {
    current->number = number;
    // Count the level's cells.
    for (const Cell& cell : current->cells) {
      SubdivisionOutcome& o = state_.outcome(cell);
      o.deepest = std::max(o.deepest, number);
      ++o.pyrays_by_level[static_cast<std::size_t>(number)];
    }
    // Make leaves of the cells without boundaries and of those that can be cut.
    resolver_.resolve(*current, state_);
    if (caster.cancelled()) break;  // some cells may have been left without a sample
    // The other cells are marginal. End the roots whose stopping rule holds.
    stop_roots(*current);
    // Split the rest in four.
    split(*current, *next);
    std::swap(current, next);
  }
  return state_.outcomes;
}

void Subdivider::start(std::span<const Root> roots) {
  CellLevel& level = levels_[0];
  level.cells.clear();
  level.entries.clear();
  for (std::uint32_t r = 0; r < roots.size(); ++r) {
    Cell cell;
    cell.square = roots[r].square;
    cell.root = r;
    cell.first = static_cast<std::uint32_t>(level.entries.size());
    cell.count = static_cast<std::uint32_t>(roots[r].list.size());
    cell.middle = roots[r].middle;
    if (cell.middle != no_sample) {
      cell.cover = state_.caster->cover(cell.middle);
      state_.outcomes[r].probes = 1;
    }
    level.entries.insert(level.entries.end(), roots[r].list.begin(), roots[r].list.end());
    level.cells.push_back(cell);
  }
}

// Ends the roots whose rule holds, or all of them at MAX, with one sample for each marginal cell.
// Takes more samples if MAX is too small for the rule.
void Subdivider::stop_roots(CellLevel& level) {
  // Cells of one root are consecutive.
  for (std::size_t i = 0; i < level.cells.size();) {
    std::size_t end = i;
    while (end < level.cells.size() && level.cells[end].root == level.cells[i].root) ++end;
    const std::span cells = std::span(level.cells).subspan(i, end - i);
    i = end;
    tally(level, cells);
    const bool holds = state_.rules.ends(tally_);
    const bool at_limit = level.number >= state_.rules.error_budget.max_level;
    SubdivisionOutcome& o = state_.outcome(cells.front());
    o.at_limit |= at_limit && tally_.marginal > 0 && !holds;
    for (Cell& cell : cells) {
      cell.done = (at_limit || holds) && !cell.is_uneven();
      o.note_uneven(cell.uneven);
    }
    TracedPyray* traced = state_.root(cells.front()).traced;
    if (tally_.marginal > 0 && traced) traced->levels.push_back(tally_);
  }
  finish_marginal(level);
}

// Counts the marginal cells of one root. Their objects matter to variants and observers only.
void Subdivider::tally(const CellLevel& level, std::span<const Cell> cells) {
  tally_.start(level.number);
  // Otherwise count the cells only.
  if (!state_.rules.variant && !state_.root(cells.front()).traced) {
    tally_.marginal = static_cast<std::uint32_t>(std::count_if(
        cells.begin(), cells.end(), [](const Cell& cell) { return !cell.is_uneven(); }));
    return;
  }
  // Find the objects near each cell.
  const HitLists& lists = state_.search->lists();
  for (const Cell& cell : cells) {
    if (cell.is_uneven()) continue;
    // Include hidden boundaries, since they may be visible beyond the edge of the surface on the
    // axis.
    near_.clear();
    bool one_edge = cell.count == 1;
    for (const std::uint32_t i : level.list(cell)) {
      if (!lists.entry(i).is_segment()) {
        near_.push_back(ObjectStatistics::clusters);
        one_edge = false;
        continue;
      }
      const auto [left, right] = lists.smooth_surfaces(i);
      if (left != FeatureEdge::none) near_.push_back(left);
      if (right != FeatureEdge::none) near_.push_back(right);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    tally_.add_cell(near_, state_.caster->surface(cell.middle), one_edge);
  }
}

void Subdivider::finish_marginal(CellLevel& level) {
  const bool at_limit = level.number >= state_.rules.error_budget.max_level;
  const bool anew = state_.rules.jitter && level.number == state_.rules.error_budget.max_level;
  // Jittered cells that end here get new samples; the others keep their centres.
  points_.clear();
  for (const Cell& cell : level.cells) {
    if (!cell.done) continue;
    points_.push_back(anew ? state_.jittered(cell.root, cell.square)
                           : glm::vec2(cell.square.centre_u(), cell.square.centre_v()));
  }
  SampleId sample = anew && !points_.empty() ? state_.caster->probe(points_) : 0;
  // Make a leaf of each.
  auto point = points_.begin();
  for (const Cell& cell : level.cells) {
    if (!cell.done) continue;
    const double share = state_.weight(cell);
    visible_.clear();
    const std::uint32_t hidden =
        state_.search->find_visible(level.list(cell), state_.sight(cell), visible_);
    state_.outcome(cell).unresolved_area += share;
    state_.outcome(cell).probes += anew;
    state_.outcome(cell).boundaries.add(state_.search->kinds_of(visible_));
    // Where MAX, and not EPS, ends a root, its samples still have to reach EPS.
    SampleId leaf = no_sample;
    if (!anew && level.number > 0 && state_.outcome(cell).at_limit)
      leaf = state_.caster->sample_saturated(state_.root(cell).id, cell.square, share);
    if (leaf == no_sample) {
      leaf = anew ? sample++ : cell.middle;
      state_.add_leaf(cell, {state_.root(cell).id, leaf, share, {cell.square, {}, true}});
    }
    if (TracedCell* traced =
            state_.trace(level, cell, at_limit ? CellFate::finest : CellFate::stopped, visible_)) {
      traced->hidden = hidden;
      traced->samples.push_back({leaf, state_.root(cell).place(*point), share, {}, {}});
    }
    ++point;
  }
  state_.hand_out();
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void Subdivider::split(const CellLevel& level, CellLevel& next) {
  next.cells.clear();
  next.entries.clear();
  for (const Cell& cell : level.cells) {
    if (state_.caster->cancelled()) return;
    if (state_.root(cell).traced) {
      visible_.clear();
      state_.search->find_visible(level.list(cell), state_.sight(cell), visible_);
      state_.trace(level, cell, cell.is_uneven() ? CellFate::uneven : CellFate::split, visible_);
    }
    for (int i = 0; i < 4; ++i) {
      Cell child;
      child.square = cell.square.quarter(i);
      child.root = cell.root;
      // The parent's centre is this child's corner, so its surface may hide boundaries here, too.
      child.cover = cell.cover;
      state_.search->refine(child.square, state_.sight(child), level.list(cell), list_,
                            cell.middle != no_sample);
      child.first = static_cast<std::uint32_t>(next.entries.size());
      child.count = static_cast<std::uint32_t>(list_.size());
      next.entries.insert(next.entries.end(), list_.begin(), list_.end());
      next.cells.push_back(child);
    }
  }
}

}  // namespace asos
