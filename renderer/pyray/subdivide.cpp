#include "renderer/pyray/subdivide.h"

#include <algorithm>
#include <cmath>

namespace asos {
std::span<const SubdivisionOutcome> Subdivider::run(HitLists& lists, std::span<const Root> roots,
                                                    const SubdivisionRules& rules, Caster& caster) {
  hits_ = &lists;
  caster_ = &caster;
  rules_ = rules;
  roots_ = roots;
  detector_.emplace(lists.frame(), rules.detection);
  outcomes_.assign(roots.size(), {});
  start(roots);
  Level* current = &levels_[0];
  Level* next = &levels_[1];
  for (level_ = 0; !current->cells.empty() && !caster.cancelled(); ++level_) {
    // What can be resolved becomes leaves; what cannot stays, marginal.
    for (const Cell& cell : current->cells) {
      SubdivisionOutcome& o = outcome(cell);
      o.deepest = std::max(o.deepest, level_);
      ++o.pyrays_by_level[static_cast<std::size_t>(level_)];
    }
    resolve(*current);
    if (caster.cancelled()) break;  // some cells may have been left without a sample
    stop_roots(*current);
    split(*current, *next);
    std::swap(current, next);
  }
  trace_ = nullptr;
  return outcomes_;
}

void Subdivider::trace(std::uint32_t root_id, SubdivisionTrace& into) {
  traced_root_ = root_id;
  trace_ = &into;
}

void Subdivider::start(std::span<const Root> roots) {
  Level& level = levels_[0];
  level.cells.clear();
  level.entries.clear();
  for (std::uint32_t r = 0; r < roots.size(); ++r) {
    Cell cell;
    cell.square = roots[r].square;
    cell.root = r;
    cell.first = static_cast<std::uint32_t>(level.entries.size());
    cell.count = static_cast<std::uint32_t>(roots[r].list.size());
    cell.centre = roots[r].centre;
    if (cell.centre != Caster::no_sample) cell.cover = caster_->cover(cell.centre);
    level.entries.insert(level.entries.end(), roots[r].list.begin(), roots[r].list.end());
    level.cells.push_back(cell);
  }
}

// Ends the roots whose rule holds, or all of them at MAX, with a sample for each marginal cell.
void Subdivider::stop_roots(Level& level) {
  // Cells of one root are consecutive.
  for (std::size_t i = 0; i < level.cells.size();) {
    std::size_t end = i;
    while (end < level.cells.size() && level.cells[end].root == level.cells[i].root) ++end;
    const std::span cells = std::span(level.cells).subspan(i, end - i);
    i = end;
    tally(level, cells);
    const bool holds = tally_.holds(rules_.rule, rules_.eps);
    const bool at_limit = level_ >= rules_.max_level;
    SubdivisionOutcome& o = outcome(cells.front());
    o.at_limit |= at_limit && tally_.marginal > 0 && !holds;
    for (Cell& cell : cells) {
      cell.done = (at_limit || holds) && !cell.is_uneven();
      o.uneven_shading |= cell.uneven == Unevenness::shading;
      o.uneven_shadow |= cell.uneven == Unevenness::shadow;
    }
    if (tally_.marginal > 0 && traced(cells.front())) trace_->levels.push_back(tally_);
  }
  finish_marginal(level);
}

// Counts the marginal cells of one root. What they are marginal to matters to the published rule
// and to who looks on only.
void Subdivider::tally(const Level& level, std::span<const Cell> cells) {
  tally_.start(level_);
  if (rules_.rule == StoppingRule::unresolved && !trace_) {
    tally_.marginal = static_cast<std::uint32_t>(std::count_if(
        cells.begin(), cells.end(), [](const Cell& cell) { return !cell.is_uneven(); }));
    return;
  }
  for (const Cell& cell : cells) {
    if (cell.is_uneven()) continue;
    // All that is near, also behind what the axis hits: it may show beyond the edge of that.
    near_.clear();
    bool one_edge = cell.count == 1;
    for (const std::uint32_t i : level.list(cell)) {
      if (!hits_->entry(i).is_segment()) {
        near_.push_back(ObjectTally::clusters);
        one_edge = false;
        continue;
      }
      const auto [left, right] = hits_->sheets(i);
      if (left != FeatureEdge::none) near_.push_back(left);
      if (right != FeatureEdge::none) near_.push_back(right);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    tally_.add_cell(near_, caster_->surface(cell.centre), one_edge);
  }
}

void Subdivider::finish_marginal(Level& level) {
  points_.clear();
  for (const Cell& cell : level.cells) {
    if (!cell.done) continue;
    points_.push_back(rules_.jitter && level_ == rules_.max_level
                          ? jittered(cell.root, cell.square)
                          : glm::vec2(cell.square.centre_u(), cell.square.centre_v()));
  }
  const bool anew = rules_.jitter && level_ == rules_.max_level && !points_.empty();
  SampleId sample = anew ? caster_->probe(points_) : 0;
  auto point = points_.begin();
  for (const Cell& cell : level.cells) {
    if (!cell.done) continue;
    const double share = weight(cell);
    outcome(cell).unresolved_area += share;
    find_boundaries(level, cell);
    const SampleId leaf = anew ? sample++ : cell.centre;
    caster_->leaf(roots_[cell.root].id, leaf, share, {cell.square, {}, true});
    if (TracedCell* seen =
            record(level, cell, level_ < rules_.max_level ? CellFate::stopped : CellFate::finest))
      seen->leaves.push_back({leaf, *point, share});
    ++point;
  }
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void Subdivider::split(const Level& level, Level& next) {
  next.cells.clear();
  next.entries.clear();
  for (const Cell& cell : level.cells) {
    if (caster_->cancelled()) return;
    (void)record(level, cell, cell.is_uneven() ? CellFate::uneven : CellFate::split);
    for (int i = 0; i < 4; ++i) {
      Cell child;
      child.square = cell.square.quarter(i);
      child.root = cell.root;
      // The parent's centre is this child's corner: its surface may hide boundaries here too.
      child.cover = cell.cover;
      const Square reach = detector_->reach(child.square);
      hits_->refine(reach, HidingPlane::of(child.cover, hits_->frame(), reach.side),
                    level.list(cell), list_, cell.centre != Caster::no_sample);
      std::erase_if(list_, [&](std::uint32_t entry) {
        return hits_->entry(entry).is_segment() &&
               !detector_->near(hits_->segment(entry), child.square);
      });
      child.first = static_cast<std::uint32_t>(next.entries.size());
      child.count = static_cast<std::uint32_t>(list_.size());
      next.entries.insert(next.entries.end(), list_.begin(), list_.end());
      next.cells.push_back(child);
    }
  }
}

double Subdivider::weight(const Cell& cell) const {
  const double side =
      static_cast<double>(cell.square.side) / static_cast<double>(roots_[cell.root].square.side);
  return side * side;
}

bool Subdivider::traced(const Cell& cell) const {
  return trace_ && roots_[cell.root].id == traced_root_;
}

// What a cell looked like when it met its fate; null where nobody looks on.
TracedCell* Subdivider::record(const Level& level, const Cell& cell, CellFate fate) {
  if (!traced(cell)) return nullptr;
  TracedCell& traced = trace_->cells.emplace_back();
  traced.level = level_;
  traced.square = cell.square;
  traced.fate = fate;
  const Square reach = detector_->reach(cell.square);
  const HidingPlane hiding = HidingPlane::of(cell.cover, hits_->frame(), reach.side);
  find_visible(level.list(cell), reach, hiding);
  for (const std::uint32_t i : visible_) {
    if (hits_->entry(i).is_segment()) {
      traced.boundaries.push_back(hits_->segment(i));
    } else {
      ++traced.clusters;
    }
  }
  traced.hidden = cell.count - static_cast<std::uint32_t>(visible_.size());
  if (fate == CellFate::cut && traced.clusters > 0 && tell_apart(cell, hiding)) {
    // What the cut told apart.
    traced.clusters = 0;
    traced.boundaries.clear();
    for (const std::uint32_t i : told_apart_) traced.boundaries.push_back(hits_->segment(i));
  }
  return &traced;
}

}  // namespace asos
