#include "renderer/pyray/cell_resolver.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>

namespace asos {
namespace {

glm::vec2 middle_of(const Square& s) {
  return {s.centre_u(), s.centre_v()};
}

}  // namespace

// Resolves cells first with the boundaries hidden by the parent's sample, then with those hidden by
// the cell's own.
void CellResolver::resolve(CellLevel& level, SubdivisionState& state) {
  level_ = &level;
  state_ = &state;
  for (const bool with_own_sample : {false, true}) {
    plans_.clear();
    points_.clear();
    parts_.clear();
    borders_.clear();
    hidden_.clear();
    drawn_.clear();
    for (std::uint32_t i = 0; i < level.cells.size(); ++i) {
      const Cell& cell = level.cells[i];
      if (!cell.done && !cell.is_uneven() && !state.caster->cancelled()) plan(i, with_own_sample);
    }
    carry_out();
  }
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void CellResolver::plan(std::uint32_t cell_index, bool with_own_sample) {
  const Cell& cell = level_->cells[cell_index];
  const std::span list = level_->list(cell);
  const bool exact = state_->rules.cuts_cells();
  const glm::vec2 middle = middle_of(cell.square);
  const bool has_middle = cell.middle != no_sample;
  std::size_t boundaries = 0;
  visible_.clear();
  // Boundaries hidden from one sample are visible elsewhere in the cell, so cut along all of them.
  if (with_own_sample && cell.nothing_hides) {
    state_->search->find_visible(list, state_->search->sight(cell.square, OccluderPlane::none()),
                                 visible_);
    if (plan_cut(cell_index, {}, boundaries)) return;
    visible_.clear();
  }
  if (with_own_sample && !has_middle) {
    // A cut failed, because its parts were not uniform. The cell is marginal.
    add_plan(Plan::Kind::middle, cell_index, std::span(&middle, 1));
    return;
  }
  if (with_own_sample && !(cell.fresh && cell.cover.valid)) return;

  // No visible boundary: one sample represents the cell.
  const BoundarySearch::Sight sight = state_->sight(cell);
  state_->search->find_visible(list, sight, visible_);
  if (visible_.empty()) {
    add_plan(Plan::Kind::uniform, cell_index,
             has_middle ? std::span<const glm::vec2>() : std::span(&middle, 1));
    return;
  }
  // Few boundaries: one sample in each part between them. Far too many: samples distributed over
  // the cell.
  if (exact && plan_cut(cell_index, sight.hiding, boundaries)) return;
  // Saturation needs a sample first: its surface might hide all of the boundaries.
  const bool seen = cell.cover.valid || has_middle;
  if (exact && seen && plan_saturated(cell_index, boundaries)) return;
  // Otherwise the cell is marginal.
  if (!has_middle) add_plan(Plan::Kind::middle, cell_index, std::span(&middle, 1));
}

// Plans a cut of the cell along its visible boundaries, with one sample in each part. If there are
// too many, sets `boundaries` to their number.
bool CellResolver::plan_cut(std::uint32_t cell_index, const CellOccluder& hiding,
                            std::size_t& boundaries) {
  const Cell& cell = level_->cells[cell_index];
  // Cut the cell.
  const CellCut cut =
      cutter_.cut({cell.square, level_->number, state_->root(cell).square.side, hiding}, visible_,
                  state_->rules, state_->search->lists());
  boundaries = cut.boundaries;
  if (cut.parts.empty()) return false;
  // Many parts may cost more than samples of all of them.
  if (cut.parts.size() > LeafTuning::few_parts && better_sampled(cell, cut.parts.size())) {
    boundaries = std::max(boundaries, cut.parts.size());
    return false;
  }
  // Plan a sample in each part.
  Plan& plan = add_plan(Plan::Kind::cut, cell_index, {});
  plan.boundaries = state_->search->kinds_of(cut.along);
  plan.points.count = static_cast<std::uint32_t>(cut.parts.size());
  plan.first_part = static_cast<std::uint32_t>(parts_.size());
  const auto first_edge = static_cast<std::uint32_t>(borders_.size());
  borders_.insert(borders_.end(), cut.borders.begin(), cut.borders.end());
  for (const CellPart& part : cut.parts) {
    parts_.push_back(part);
    parts_.back().first_edge += first_edge;
    points_.emplace_back(part.u, part.v);
  }
  // Record the list's entries that are not visible; `visible_` is in the list's order.
  plan.hidden.first = static_cast<std::uint32_t>(hidden_.size());
  auto next = visible_.begin();
  for (const std::uint32_t i : level_->list(cell)) {
    if (next != visible_.end() && *next == i) {
      ++next;
    } else {
      hidden_.push_back(i);
    }
  }
  hidden_.insert(hidden_.end(), cut.hidden.begin(), cut.hidden.end());
  plan.hidden.count = static_cast<std::uint32_t>(hidden_.size()) - plan.hidden.first;
  keep_for_observers(cell, plan, cut.along);
  return true;
}

// Returns whether a root that has a sample costs less by samples than by shading `parts` parts.
// Smaller cells were split for accuracy, so they are not sampled.
bool CellResolver::better_sampled(const Cell& cell, std::size_t parts) const {
  const bool seen = cell.cover.valid || cell.middle != no_sample;
  return level_->number == 0 && state_->rules.error_budget.max_level > 0 && seen &&
         state_->caster->samples_suffice(state_->weight(cell), parts);
}

// Plans a saturated cell. There are two cases. Its boundaries are so many that samples cost less
// than the parts between them. Or each boundary crosses several of the finest cells, so that nearly
// all of these would be marginal; then their jittered samples are taken immediately (design section
// 5).
bool CellResolver::plan_saturated(std::uint32_t cell_index, std::size_t boundaries) {
  const Cell& cell = level_->cells[cell_index];
  const int below = state_->rules.error_budget.max_level - level_->number;
  const std::uint32_t n = 1u << below;
  if (below < 1) return false;
  // Each boundary adds at least one part, and each crossing of two boundaries one more.
  if (!better_sampled(cell, 2 * boundaries)) {
    const auto few = static_cast<std::size_t>(state_->rules.limits.most_boundaries);
    if (boundaries <= few || 4 * boundaries < n * n) return false;
  }
  Plan& plan = add_plan(Plan::Kind::saturated, cell_index, {});
  plan.boundaries = state_->search->kinds_of(visible_);
  keep_for_observers(cell, plan, visible_);
  plan.own_samples =
      state_->caster->sample_saturated(state_->root(cell).id, cell.square, state_->weight(cell));
  if (plan.own_samples != no_sample) return true;
  plan.points.count = n * n;
  for (std::uint32_t i = 0; i < n * n; ++i)
    points_.push_back(
        state_->jittered(cell.root, cell.square.part(static_cast<int>(n), static_cast<int>(i))));
  return true;
}

CellResolver::Plan& CellResolver::add_plan(Plan::Kind kind, std::uint32_t cell_index,
                                           std::span<const glm::vec2> points) {
  Plan& plan = plans_.emplace_back();
  plan.kind = kind;
  plan.cell = cell_index;
  plan.points = {static_cast<std::uint32_t>(points_.size()),
                 static_cast<std::uint32_t>(points.size())};
  points_.insert(points_.end(), points.begin(), points.end());
  return plan;
}

void CellResolver::keep_for_observers(const Cell& cell, Plan& plan,
                                      std::span<const std::uint32_t> visible) {
  if (!state_->root(cell).traced) return;
  plan.visible = {static_cast<std::uint32_t>(drawn_.size()),
                  static_cast<std::uint32_t>(visible.size())};
  drawn_.insert(drawn_.end(), visible.begin(), visible.end());
}

// Takes all samples of the plans, and then makes the leaves.
void CellResolver::carry_out() {
  const SampleId first = points_.empty() ? 0 : state_->caster->probe(points_);
  for (const Plan& plan : plans_) {
    Cell& cell = level_->cells[plan.cell];
    const SampleId sample = first + plan.points.first;
    state_->outcome(cell).probes += plan.points.count;
    switch (plan.kind) {
      case Plan::Kind::uniform:
        finish_uniform(cell, plan, sample);
        break;
      case Plan::Kind::cut:
        finish_cut(cell, plan, sample);
        break;
      case Plan::Kind::middle:
        cell.middle = sample;
        cell.fresh = true;
        cell.cover = state_->caster->cover(sample);
        break;
      case Plan::Kind::saturated:
        finish_saturated(cell, plan, sample);
        break;
    }
  }
  state_->hand_out();
}

void CellResolver::finish_uniform(Cell& cell, const Plan& plan, SampleId first) {
  const SampleId sample = plan.points.count ? first : cell.middle;
  PyrayLeaf leaf{state_->root(cell).id, sample, state_->weight(cell), {cell.square, {}}};
  leaf.decision =
      state_->caster->decide(leaf, level_->number < state_->rules.error_budget.max_level);
  if (leaf.decision.splits()) {
    cell.uneven = leaf.decision.cause;
    cell.middle = sample;
    cell.cover = state_->caster->cover(cell.middle);
    return;
  }
  const CellFate fate = leaf.decision.sampled() ? CellFate::sampled : CellFate::uniform;
  if (TracedCell* traced = trace(cell, plan, fate)) {
    const glm::vec2 at = state_->root(cell).place(middle_of(cell.square));
    traced->samples.push_back({sample, at, leaf.weight, {}, {}});
  }
  state_->add_leaf(cell, leaf);
  cell.done = true;
}

void CellResolver::finish_cut(Cell& cell, const Plan& plan, SampleId first) {
  // The samples must confirm that boundaries counted as hidden are hidden.
  if (!stay_hidden(cell, plan, first)) {
    cell.nothing_hides = true;
    return;
  }
  // Make leaves of the parts. If the shading of only one varies, split the whole cell.
  const int finest = state_->rules.error_budget.max_level;
  const double whole = state_->weight(cell);
  const std::size_t first_leaf = state_->leaves.size();
  for (std::uint32_t i = 0; i < plan.points.count; ++i) {
    const CellPart& part = parts_[plan.first_part + i];
    PyrayLeaf leaf{state_->root(cell).id,
                   first + i,
                   whole * part.area,
                   {cell.square, std::span(borders_).subspan(part.first_edge, part.edge_count)}};
    leaf.decision = state_->caster->decide(leaf, level_->number < finest);
    if (leaf.decision.splits()) {
      cell.uneven = leaf.decision.cause;
      state_->leaves.resize(first_leaf);
      // Without a sample at its centre, the cell has no cover for its children.
      if (cell.middle == no_sample) cell.cover = OccluderPlane::none();
      return;
    }
    state_->add_leaf(cell, leaf);
  }
  // Record the cut for observers.
  if (TracedCell* traced = trace(cell, plan, CellFate::cut)) {
    traced->hidden = plan.hidden.count;
    for (std::uint32_t i = 0; i < plan.points.count; ++i) {
      const PyrayLeaf& leaf = state_->leaves[first_leaf + i];
      const glm::vec2 at = state_->root(cell).place(points_[plan.points.first + i]);
      traced->samples.push_back(
          {leaf.sample, at, leaf.weight, {}, {}, state_->root(cell).placed_border(leaf.region)});
    }
  }
  // A cut counts as one more level.
  if (plan.points.count > 1) {
    SubdivisionOutcome& o = state_->outcome(cell);
    o.deepest = std::max(o.deepest, std::min(level_->number + 1, std::max(1, finest)));
    o.boundaries.add(plan.boundaries);
  }
  cell.done = true;
}

void CellResolver::finish_saturated(Cell& cell, const Plan& plan, SampleId first) {
  const int finest = state_->rules.error_budget.max_level;
  const std::uint32_t n = 1u << (finest - level_->number);
  const double whole = state_->weight(cell);
  const Root& root = state_->root(cell);
  TracedCell* traced = trace(cell, plan, CellFate::saturated);
  // Make a leaf of each jittered sample. The caster's own samples need none.
  for (std::uint32_t i = 0; i < plan.points.count; ++i) {
    const double share = whole / plan.points.count;
    const LeafRegion region{cell.square.part(static_cast<int>(n), static_cast<int>(i)), {}, true};
    state_->add_leaf(cell, {root.id, first + i, share, region});
    if (traced) {
      const glm::vec2 at = root.place(points_[plan.points.first + i]);
      traced->samples.push_back({first + i, at, share, {}, {}, root.placed_border(region)});
    }
  }
  if (traced && plan.own_samples != no_sample) {
    const glm::vec2 at = root.place(middle_of(cell.square));
    traced->samples.push_back({plan.own_samples, at, whole, {}, {}});
  }
  // Count the finest cells as unresolved.
  SubdivisionOutcome& o = state_->outcome(cell);
  o.saturated = true;
  o.boundaries.add(plan.boundaries);
  o.deepest = finest;
  o.unresolved_area += whole;
  o.pyrays_by_level[static_cast<std::size_t>(finest)] += plan.points.count;
  cell.done = true;
}

TracedCell* CellResolver::trace(const Cell& cell, const Plan& plan, CellFate fate) const {
  return state_->trace(*level_, cell, fate,
                       std::span(drawn_).subspan(plan.visible.first, plan.visible.count));
}

// Returns whether boundaries hidden from one sample are hidden from the sample of every part that
// they cross. Otherwise the parts may not be uniform.
bool CellResolver::stay_hidden(const Cell& cell, const Plan& plan, SampleId first) const {
  if (plan.hidden.count == 0) return true;
  const HitLists& lists = state_->search->lists();
  for (std::uint32_t i = 0; i < plan.points.count; ++i) {
    const CellPart& part = parts_[plan.first_part + i];
    const CellOccluder hiding =
        CellOccluder::of(state_->caster->cover(first + i), lists.frame(), cell.square.side);
    for (std::uint32_t k = 0; k < plan.hidden.count; ++k) {
      const std::uint32_t entry = hidden_[plan.hidden.first + k];
      const HitEntry& e = lists.entry(entry);
      const bool meets = e.u0 < part.u1 && e.u1 > part.u0 && e.v0 < part.v1 && e.v1 > part.v0;
      if (meets && !lists.hidden(entry, cell.square, hiding)) return false;
    }
  }
  return true;
}

}  // namespace asos
