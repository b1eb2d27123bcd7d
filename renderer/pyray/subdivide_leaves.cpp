#include "renderer/pyray/subdivide.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Outlines of more pieces than this for each of its finest cells, and more than `most` in all, are
// not looked at one by one.
constexpr std::size_t told_apart_a_finest_cell = 16;
constexpr std::size_t least_told_apart = 256;
constexpr std::size_t most_told_apart = 1024;
// How far a simplified chain may lie from its pieces, in finest cells, in a cell of that size:
// across such a cell its area is then wrong by a sixty-fourth. In a cell n times as large it is 1/n
// of that, so that what is lost along a longer chain is the same.
constexpr float chain_tolerance = 1.0f / 64.0f;

// Part i of n x n of a square, in rows.
Square part_of(const Square& s, std::uint32_t n, std::uint32_t i) {
  const float side = s.side / static_cast<float>(n);
  return {s.u + static_cast<float>(i % n) * side, s.v + static_cast<float>(i / n) * side, side};
}

}  // namespace

// Takes the leaves of all cells that are uniform or can be cut, and a sample at the centre of the
// others. First by what the parent's sample hides, then by what the cell's own hides.
void Subdivider::resolve(Level& level) {
  for (const bool with_own_sample : {false, true}) {
    plans_.clear();
    points_.clear();
    faces_.clear();
    sides_.clear();
    excluded_.clear();
    for (std::uint32_t i = 0; i < level.cells.size(); ++i) {
      const Cell& cell = level.cells[i];
      if (!cell.done && !cell.is_uneven() && !caster_->cancelled()) plan(level, i, with_own_sample);
    }
    carry_out(level);
  }
  std::erase_if(level.cells, [](const Cell& cell) { return cell.done; });
}

void Subdivider::plan(const Level& level, std::uint32_t cell_index, bool with_own_sample) {
  const Cell& cell = level.cells[cell_index];
  const std::span list = level.list(cell);
  const glm::vec2 centre(cell.square.centre_u(), cell.square.centre_v());
  const bool has_centre = cell.centre != Caster::no_sample;
  if (with_own_sample && cell.nothing_hides) {
    find_visible(list, detector_->reach(cell.square), {});
    if (plan_faces(level, cell_index, {})) return;
  }
  if (with_own_sample && !has_centre) {
    // A cut failed: parts were not uniform. The cell is marginal.
    add_plan(Plan::Kind::centre, cell_index, std::span(&centre, 1));
    return;
  }
  if (with_own_sample && !(cell.fresh && cell.cover.valid)) return;

  const Square reach = detector_->reach(cell.square);
  const HidingPlane hiding = HidingPlane::of(cell.cover, hits_->frame(), reach.side);
  find_visible(list, reach, hiding);
  if (visible_.empty()) {
    add_plan(Plan::Kind::uniform, cell_index,
             has_centre ? std::span<const glm::vec2>() : std::span(&centre, 1));
    return;
  }
  if (rules_.exact_leaves && plan_faces(level, cell_index, hiding)) return;
  // What might all be hidden has to be seen first.
  const bool seen = cell.cover.valid || has_centre;
  if (rules_.exact_leaves && seen && plan_saturated(cell, cell_index)) return;
  if (!has_centre) add_plan(Plan::Kind::centre, cell_index, std::span(&centre, 1));
}

void Subdivider::find_visible(std::span<const std::uint32_t> list, const Square& reach,
                              const HidingPlane& hiding) {
  visible_.clear();
  for (const std::uint32_t i : list)
    if (!hits_->hidden(i, reach, hiding)) visible_.push_back(i);
}

// Cuts the cell along its visible boundaries; one sample in each part.
bool Subdivider::plan_faces(const Level& level, std::uint32_t cell_index,
                            const HidingPlane& hiding) {
  const Cell& cell = level.cells[cell_index];
  const std::size_t first_excluded = excluded_.size();
  // Both are in the list's order.
  auto next = visible_.begin();
  for (const std::uint32_t i : level.list(cell)) {
    if (next != visible_.end() && *next == i) {
      ++next;
    } else {
      excluded_.push_back(i);
    }
  }
  const std::span<const Face> faces = cut(cell, hiding);
  if (faces.empty()) {
    excluded_.resize(first_excluded);
    return false;
  }
  add_plan(Plan::Kind::faces, cell_index, {});
  Plan& plan = plans_.back();
  plan.boundaries = kinds_of(cut_along_);
  plan.count = static_cast<std::uint32_t>(faces.size());
  plan.first_face = static_cast<std::uint32_t>(faces_.size());
  const auto first_side = static_cast<std::uint32_t>(sides_.size());
  sides_.insert(sides_.end(), partition_.sides().begin(), partition_.sides().end());
  for (const Face& face : faces) {
    faces_.push_back(face);
    faces_.back().first_side += first_side;
    points_.emplace_back(face.u, face.v);
  }
  plan.first_excluded = static_cast<std::uint32_t>(first_excluded);
  plan.excluded_count = static_cast<std::uint32_t>(excluded_.size() - first_excluded);
  return true;
}

// The parts of a cell between its visible boundaries, or none where those are too many. What turns
// out to be hidden on the way is added to the excluded.
std::span<const Face> Subdivider::cut(const Cell& cell, const HidingPlane& hiding) {
  const bool clusters = std::any_of(visible_.begin(), visible_.end(),
                                    [&](std::uint32_t i) { return !hits_->entry(i).is_segment(); });
  boundary_count_ = visible_.size();
  if (clusters && !tell_apart(cell, hiding)) return {};
  segments_.clear();
  cut_along_ = clusters ? told_apart_ : visible_;
  for (const std::uint32_t i : cut_along_) segments_.push_back(hits_->segment(i));
  std::span<const Segment> boundaries = segments_;
  const auto most_segments = static_cast<std::size_t>(rules_.limits.most_boundaries);
  const auto most_pieces = static_cast<std::size_t>(rules_.limits.most_pieces);
  if (boundaries.size() > most_segments) {
    // What is not too long stays as it is: something thin between two chains would be lost.
    const bool long_chains = segments_.size() > most_pieces;
    boundaries = chains_.simplify(segments_, long_chains ? tolerance(cell) : 0.0f);
    boundary_count_ = chains_.chain_count();
    if (boundaries.size() > most_pieces || boundary_count_ > most_segments) return {};
  }
  return partition_.cut(cell.square, boundaries, most_faces());
}

float Subdivider::tolerance(const Cell& cell) const {
  const float root = roots_[cell.root].square.side;
  if (rules_.limits.tolerance > 0.0f) return rules_.limits.tolerance * root;
  const float finest = root * std::ldexp(1.0f, -rules_.max_level);
  return chain_tolerance * finest * std::min(1.0f, finest / cell.square.side);
}

// Opens what is visible down to segments, as far as those are visible themselves.
bool Subdivider::tell_apart(const Cell& cell, const HidingPlane& hiding) {
  const std::size_t finest_cells = std::size_t{1} << 2 * (rules_.max_level - level_);
  const std::size_t most =
      std::clamp(told_apart_a_finest_cell * finest_cells, least_told_apart, most_told_apart);
  // An outline is a few groups, or chains; many groups of anything else are a tangle.
  const auto groups = std::count_if(visible_.begin(), visible_.end(), [&](std::uint32_t i) {
    return !hits_->entry(i).is_segment() && !hits_->entry(i).is_chain();
  });
  if (groups > rules_.limits.most_groups) return false;
  list_.clear();
  for (const std::uint32_t i : visible_)
    if (!hits_->tell_apart(i, cell.square, tolerance(cell), most, list_)) return false;
  told_apart_.clear();
  for (const std::uint32_t i : list_)
    (hits_->hidden(i, cell.square, hiding) ? excluded_ : told_apart_).push_back(i);
  return true;
}

// So many boundaries, of which each crosses several of the finest cells, that nearly all of those
// would be marginal: their jittered samples are taken at once (design section 5).
bool Subdivider::plan_saturated(const Cell& cell, std::uint32_t cell_index) {
  const int below = rules_.max_level - level_;
  const std::uint32_t n = 1u << below;
  if (below < 1 || boundary_count_ <= static_cast<std::size_t>(rules_.limits.most_boundaries) ||
      4 * boundary_count_ < n * n)
    return false;
  add_plan(Plan::Kind::saturated, cell_index, {});
  plans_.back().boundaries = kinds_of(visible_);
  plans_.back().taken_over =
      caster_->sample_tangle(roots_[cell.root].id, cell.square, weight(cell));
  if (plans_.back().taken_over.samples > 0) return true;
  plans_.back().count = n * n;
  for (std::uint32_t i = 0; i < n * n; ++i)
    points_.push_back(jittered(cell.root, part_of(cell.square, n, i)));
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
        cell.uneven = uneven(cell, plan, sample);
        if (cell.is_uneven()) {
          if (plan.count) cell.centre = sample;
          cell.cover = caster_->cover(cell.centre);
          break;
        }
        take_leaf(cell, plan.count ? sample : cell.centre,
                  {cell.square.centre_u(), cell.square.centre_v()}, whole, {cell.square, {}},
                  record(level, cell, CellFate::uniform));
        cell.done = true;
        break;
      case Plan::Kind::faces: {
        if (!excluded_stay_hidden(cell, plan, sample)) {
          cell.nothing_hides = true;
          break;
        }
        cell.uneven = uneven(cell, plan, sample);
        if (cell.is_uneven()) {
          // Its children need a sample in the closure of each of them.
          if (cell.centre == Caster::no_sample) cell.cover = Cover::none();
          break;
        }
        TracedCell* seen = record(level, cell, CellFate::cut);
        for (std::uint32_t i = 0; i < plan.count; ++i) {
          const Face& face = faces_[plan.first_face + i];
          take_leaf(cell, sample + i, points_[plan.first_point + i], whole * face.area,
                    {cell.square, std::span(sides_).subspan(face.first_side, face.side_count)},
                    seen);
        }
        if (plan.count > 1) {
          o.deepest = std::max(o.deepest, std::min(level_ + 1, std::max(1, rules_.max_level)));
          o.boundaries.add(plan.boundaries);
        }
        cell.done = true;
        break;
      }
      case Plan::Kind::centre:
        cell.centre = sample;
        cell.fresh = true;
        cell.cover = caster_->cover(sample);
        break;
      case Plan::Kind::saturated: {
        TracedCell* seen = record(level, cell, CellFate::saturated);
        const std::uint32_t n = 1u << (rules_.max_level - level_);
        for (std::uint32_t i = 0; i < plan.count; ++i)
          take_leaf(cell, sample + i, points_[plan.first_point + i], whole / plan.count,
                    {part_of(cell.square, n, i), {}, true}, seen);
        if (seen && plan.taken_over.samples > 0)
          seen->leaves.push_back(
              {plan.taken_over.sample, {cell.square.centre_u(), cell.square.centre_v()}, whole});
        o.saturated = true;
        o.boundaries.add(plan.boundaries);
        o.deepest = rules_.max_level;
        o.unresolved_area += whole;
        o.pyrays_by_level[static_cast<std::size_t>(rules_.max_level)] +=
            plan.count + plan.taken_over.samples;
        cell.done = true;
        break;
      }
    }
  }
}

// Whether one of the leaves that a plan stands for should be split for its shading.
Unevenness Subdivider::uneven(const Cell& cell, const Plan& plan, SampleId first) const {
  if (level_ >= rules_.max_level) return Unevenness::none;
  const double whole = weight(cell);
  if (plan.kind == Plan::Kind::uniform)
    return caster_->uneven(plan.count ? first : cell.centre, whole, {cell.square, {}});
  for (std::uint32_t i = 0; i < plan.count; ++i) {
    const Face& face = faces_[plan.first_face + i];
    const LeafRegion region{cell.square,
                            std::span(sides_).subspan(face.first_side, face.side_count)};
    const Unevenness found = caster_->uneven(first + i, whole * face.area, region);
    if (found != Unevenness::none) return found;
  }
  return Unevenness::none;
}

BoundaryKinds Subdivider::kinds_of(std::span<const std::uint32_t> entries) const {
  BoundaryKinds kinds;
  for (const std::uint32_t i : entries) {
    const auto kind =
        hits_->entry(i).is_segment() ? hits_->kind(i) : std::optional(FeatureKind::silhouette);
    if (kind) kinds.add(*kind);
  }
  return kinds;
}

// Of a cell that stays marginal.
void Subdivider::find_boundaries(const Level& level, const Cell& cell) {
  const Square reach = detector_->reach(cell.square);
  find_visible(level.list(cell), reach, HidingPlane::of(cell.cover, hits_->frame(), reach.side));
  outcome(cell).boundaries.add(kinds_of(visible_));
}

void Subdivider::take_leaf(const Cell& cell, SampleId sample, glm::vec2 at, double share,
                           const LeafRegion& region, TracedCell* seen) {
  caster_->leaf(roots_[cell.root].id, sample, share, region);
  if (seen) seen->leaves.push_back({sample, at, share});
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

// A few parts are worth a cut at any level: a sample each, where MAX would leave one for all of
// them. More only where they replace several levels of children: half as many as there are finest
// cells.
std::size_t Subdivider::most_faces() const {
  const int below = rules_.max_level - level_;
  return static_cast<std::size_t>(
      std::max(rules_.limits.least_faces, std::min(64, (1 << 2 * below) / 2)));
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
