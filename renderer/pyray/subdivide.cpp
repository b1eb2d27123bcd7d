#include "renderer/pyray/subdivide.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Arrangements of more lines than this cost more than four children do.
constexpr std::size_t most_segments = 12;

}  // namespace

std::span<const SubdivisionOutcome> Subdivider::run(HitLists& lists, std::span<const Root> roots,
                                                    const SubdivisionRules& rules, Caster& caster) {
  hits_ = &lists;
  caster_ = &caster;
  rules_ = rules;
  roots_ = roots;
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
    stop_roots(*current);
    split(*current, *next);
    std::swap(current, next);
  }
  return outcomes_;
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

// Takes the leaves of all cells that are uniform or can be cut, and a sample at the centre of the
// others. First by what the parent's sample hides, then by what the cell's own hides.
void Subdivider::resolve(Level& level) {
  for (const bool with_own_sample : {false, true}) {
    plans_.clear();
    points_.clear();
    faces_.clear();
    excluded_.clear();
    for (std::uint32_t i = 0; i < level.cells.size(); ++i)
      if (!level.cells[i].done && !caster_->cancelled()) plan(level, i, with_own_sample);
    carry_out(level);
  }
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void Subdivider::plan(const Level& level, std::uint32_t cell_index, bool with_own_sample) {
  const Cell& cell = level.cells[cell_index];
  const std::span list = level.list(cell);
  const glm::vec2 centre(cell.square.centre_u(), cell.square.centre_v());
  const bool has_centre = cell.centre != Caster::no_sample;
  if (with_own_sample && !has_centre) {
    // A cut failed: parts were not uniform. The cell is marginal.
    add_plan(Plan::Kind::centre, cell_index, std::span(&centre, 1));
    return;
  }
  if (with_own_sample && !(cell.fresh && cell.cover.valid)) return;
  if (!with_own_sample && list.size() > most_segments && plan_saturated(cell, cell_index)) return;

  const HidingPlane hiding = HidingPlane::of(cell.cover, hits_->frame(), cell.square.side);
  visible_.clear();
  for (const std::uint32_t i : list)
    if (!hits_->hidden(i, cell.square, hiding)) visible_.push_back(i);
  if (visible_.empty()) {
    add_plan(Plan::Kind::uniform, cell_index,
             has_centre ? std::span<const glm::vec2>() : std::span(&centre, 1));
    return;
  }
  if (rules_.exact_leaves && plan_faces(level, cell_index, visible_)) return;
  if (!has_centre) add_plan(Plan::Kind::centre, cell_index, std::span(&centre, 1));
}

// Cuts the cell along its visible boundaries; one sample in each part.
bool Subdivider::plan_faces(const Level& level, std::uint32_t cell_index,
                            std::span<const std::uint32_t> visible) {
  if (visible.size() > most_segments) return false;
  segments_.clear();
  for (const std::uint32_t i : visible) {
    if (!hits_->entry(i).is_segment()) return false;
    segments_.push_back(hits_->segment(i));
  }
  const Cell& cell = level.cells[cell_index];
  const std::span<const Face> faces = partition_.cut(cell.square, segments_, most_faces());
  if (faces.empty()) return false;
  add_plan(Plan::Kind::faces, cell_index, {});
  Plan& plan = plans_.back();
  plan.count = static_cast<std::uint32_t>(faces.size());
  plan.first_face = static_cast<std::uint32_t>(faces_.size());
  for (const Face& face : faces) {
    faces_.push_back(face);
    points_.emplace_back(face.u, face.v);
  }
  plan.first_excluded = static_cast<std::uint32_t>(excluded_.size());
  // Both are in the list's order.
  auto next = visible.begin();
  for (const std::uint32_t i : level.list(cell)) {
    if (next != visible.end() && *next == i) {
      ++next;
    } else {
      excluded_.push_back(i);
    }
  }
  plan.excluded_count = static_cast<std::uint32_t>(excluded_.size()) - plan.first_excluded;
  return true;
}

// About as many entries as finest cells: nearly all children would be marginal, so their jittered
// samples are taken at once (design section 5).
bool Subdivider::plan_saturated(const Cell& cell, std::uint32_t cell_index) {
  const int below = rules_.max_level - level_;
  const std::uint32_t n = 1u << below;
  if (!rules_.exact_leaves || below < 1 || cell.count < n * n) return false;
  add_plan(Plan::Kind::saturated, cell_index, {});
  plans_.back().count = n * n;
  const float side = cell.square.side / static_cast<float>(n);
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      points_.push_back(jittered(cell.root, {cell.square.u + static_cast<float>(x) * side,
                                             cell.square.v + static_cast<float>(y) * side, side}));
    }
  }
  return true;
}

void Subdivider::add_plan(Plan::Kind kind, std::uint32_t cell_index,
                          std::span<const glm::vec2> points) {
  Plan plan;
  plan.kind = kind;
  plan.cell = cell_index;
  plan.first_point = static_cast<std::uint32_t>(points_.size());
  plan.count = static_cast<std::uint32_t>(points.size());
  points_.insert(points_.end(), points.begin(), points.end());
  plans_.push_back(plan);
}

// Takes all the samples that the plans wait for, and then the leaves.
void Subdivider::carry_out(Level& level) {
  const SampleId first = points_.empty() ? 0 : caster_->probe(points_);
  for (const Plan& plan : plans_) {
    Cell& cell = level.cells[plan.cell];
    SubdivisionOutcome& o = outcome(cell);
    const SampleId sample = first + plan.first_point;
    const double whole = weight(cell);
    switch (plan.kind) {
      case Plan::Kind::uniform:
        caster_->leaf(roots_[cell.root].id, plan.count ? sample : cell.centre, whole);
        cell.done = true;
        break;
      case Plan::Kind::faces:
        if (!excluded_stay_hidden(cell, plan, sample)) break;
        for (std::uint32_t i = 0; i < plan.count; ++i)
          caster_->leaf(roots_[cell.root].id, sample + i, whole * faces_[plan.first_face + i].area);
        if (plan.count > 1)
          o.deepest = std::max(o.deepest, std::min(level_ + 1, std::max(1, rules_.max_level)));
        cell.done = true;
        break;
      case Plan::Kind::centre:
        cell.centre = sample;
        cell.fresh = true;
        cell.cover = caster_->cover(sample);
        break;
      case Plan::Kind::saturated:
        for (std::uint32_t i = 0; i < plan.count; ++i)
          caster_->leaf(roots_[cell.root].id, sample + i, whole / plan.count);
        o.saturated = true;
        o.deepest = rules_.max_level;
        o.unresolved_area += whole;
        o.pyrays_by_level[static_cast<std::size_t>(rules_.max_level)] += plan.count;
        cell.done = true;
        break;
    }
  }
}

// What was left out as hidden from one sample has to be hidden from the sample of every part that
// it crosses; otherwise the parts may not be uniform.
bool Subdivider::excluded_stay_hidden(const Cell& cell, const Plan& plan, SampleId first) const {
  if (plan.excluded_count == 0) return true;
  for (std::uint32_t i = 0; i < plan.count; ++i) {
    const Face& face = faces_[plan.first_face + i];
    const HidingPlane hiding =
        HidingPlane::of(caster_->cover(first + i), hits_->frame(), cell.square.side);
    for (std::uint32_t k = 0; k < plan.excluded_count; ++k) {
      const std::uint32_t entry = excluded_[plan.first_excluded + k];
      const HitEntry& e = hits_->entry(entry);
      const bool meets = e.u0 < face.u1 && e.u1 > face.u0 && e.v0 < face.v1 && e.v1 > face.v0;
      if (meets && !hits_->hidden(entry, cell.square, hiding)) return false;
    }
  }
  return true;
}

// Ends the roots whose rule holds, or all of them at MAX, with a sample for each marginal cell.
void Subdivider::stop_roots(Level& level) {
  if (level_ < rules_.max_level) {
    // Cells of one root are consecutive.
    for (std::size_t i = 0; i < level.cells.size();) {
      std::size_t end = i;
      while (end < level.cells.size() && level.cells[end].root == level.cells[i].root) ++end;
      if (holds_rule(level, i, end - i))
        for (std::size_t k = i; k < end; ++k) level.cells[k].done = true;
      i = end;
    }
  } else {
    for (Cell& cell : level.cells) cell.done = true;
  }
  finish_marginal(level);
}

// With exact leaves the unresolved area bounds the error by itself. Point leaves: the rule of
// CGF'98 section 3.1, with 6.2's refinement where one edge only is near. In and out are counted for
// the surface that most axes meet.
bool Subdivider::holds_rule(const Level& level, std::size_t first, std::size_t count) const {
  const std::span cells = std::span(level.cells).subspan(first, count);
  const double cell_area = weight(cells.front());
  const auto marginal = static_cast<double>(count);
  if (rules_.exact_leaves) return marginal * cell_area <= rules_.eps;
  std::ptrdiff_t most = 0;
  bool one_edge = true;
  for (const Cell& cell : cells) {
    const std::uint32_t surface = caster_->surface(cell.centre);
    most = std::max(most, std::count_if(cells.begin(), cells.end(), [&](const Cell& other) {
                      return caster_->surface(other.centre) == surface;
                    }));
    one_edge &= cell.count == 1;
  }
  const double in = static_cast<double>(most);
  return std::max(in, marginal - in) * cell_area * (one_edge ? 0.5 : 1.0) <= rules_.eps;
}

void Subdivider::finish_marginal(Level& level) {
  if (rules_.jitter && level_ == rules_.max_level) {
    points_.clear();
    for (const Cell& cell : level.cells) points_.push_back(jittered(cell.root, cell.square));
    SampleId sample = points_.empty() ? 0 : caster_->probe(points_);
    for (Cell& cell : level.cells) cell.centre = sample++;
  }
  for (const Cell& cell : level.cells) {
    if (!cell.done) continue;
    outcome(cell).unresolved_area += weight(cell);
    caster_->leaf(roots_[cell.root].id, cell.centre, weight(cell));
  }
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void Subdivider::split(const Level& level, Level& next) {
  next.cells.clear();
  next.entries.clear();
  for (const Cell& cell : level.cells) {
    if (caster_->cancelled()) return;
    for (int i = 0; i < 4; ++i) {
      Cell child;
      child.square = cell.square.quarter(i);
      child.root = cell.root;
      // The parent's centre is this child's corner: its surface may hide boundaries here too.
      child.cover = cell.cover;
      hits_->refine(child.square, HidingPlane::of(child.cover, hits_->frame(), child.square.side),
                    level.list(cell), list_);
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

// One boundary is worth a cut at any level; more parts only where they replace several levels of
// children.
std::size_t Subdivider::most_faces() const {
  return static_cast<std::size_t>(2 + 2 * std::min(3, rules_.max_level - level_));
}

// A point of a cell that depends on the root's seed and the cell only.
glm::vec2 Subdivider::jittered(std::uint32_t root, const Square& s) const {
  const Root& r = roots_[root];
  const auto x = static_cast<std::uint64_t>((s.u - r.square.u) / r.square.side * 65536.0f);
  const auto y = static_cast<std::uint64_t>((s.v - r.square.v) / r.square.side * 65536.0f);
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
  return {s.u + s.side * du, s.v + s.side * dv};
}

}  // namespace asos
