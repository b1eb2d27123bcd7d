#include "renderer/pyray/tracer.h"

#include "renderer/pyray/safety_net.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// Records the leaves' results, which the caster knows after it has taken them.
void fill_results(TracedPyray* traced, const Caster& caster) {
  if (!traced) return;
  for (TracedCell& cell : traced->cells) {
    for (TracedSample& sample : cell.samples) {
      sample.radiance = caster.result(sample.id);
      sample.triangle = caster.triangle(sample.id);
    }
  }
}

}  // namespace

Trace Tracer::trace(const FeatureSet& features, const Pyray& pyray, const SubdivisionRules& rules,
                    Caster& caster, TracedPyray* traced) {
  start(features, pyray.frame, pyray.bounds, rules, pyray.square.side);
  return trace_searched(pyray, pyray.outline, rules, caster, traced);
}

bool Tracer::search(const FeatureSet& features, const Pyray& pyray, const SubdivisionRules& rules) {
  start(features, pyray.frame, pyray.bounds, rules, pyray.square.side);
  search_.lists().refine(pyray.square, {}, search_.lists().scene_root(), scratch_);
  return !scratch_.empty();
}

Trace Tracer::trace_searched(const Pyray& pyray, std::span<const BorderEdge> outline,
                             const SubdivisionRules& rules, Caster& caster, TracedPyray* traced) {
  HitLists& lists = search_.lists();
  for (const BorderEdge& edge : outline) lists.add_boundary(edge.from, edge.to);

  // Sample the centre first: its surface may hide everything else, and if not, it costs one ray.
  const glm::vec2 middle(pyray.square.centre_u(), pyray.square.centre_v());
  Root root;
  root.square = pyray.square;
  root.middle = caster.probe(std::span(&middle, 1));
  root.seed = pyray.seed;
  root.traced = traced;
  caster.middles_known(1);

  // Find the boundaries in front of that surface.
  BoundarySearch::List& list = list_;
  search_.refine(root.square, search_.sight(root.square, caster.cover(root.middle)), lists.root(),
                 list, true);
  root.list = list;
  Trace result;
  result.timed_out = list.size() > rules.most_entries || lists.exhausted() || caster.gives_up();
  if (result.timed_out) return result;

  // Subdivide.
  result.outcome = subdivider_.run(search_, std::span(&root, 1), rules, caster).front();
  caster.finish();
  fill_results(traced, caster);
  return result;
}

std::span<const Trace> Tracer::trace(const FeatureSet& features, const FatPyray& fat,
                                     const SubdivisionRules& rules, Caster& caster,
                                     std::uint32_t observed, TracedPyray* traced) {
  const auto count = static_cast<std::size_t>(fat.side * fat.side);
  traces_.assign(count, {});
  look_through_middles(fat, caster);
  start(features, fat.frame, fat.bounds, rules, fat.square_of(0, 0, 1).side);
  for (const BorderEdge& edge : fat.outline) search_.lists().add_boundary(edge.from, edge.to);
  fat_search_.run(search_, fat, [&](int x, int y) { return caster.cover(fat.index(x, y)); });
  find_missed_splits(fat, caster);
  finish_roots(fat, rules, caster, observed, traced);
  caster.finish();
  fill_results(traced, caster);
  return traces_;
}

std::optional<std::span<const Segment>> Tracer::boundaries(const FeatureSet& features,
                                                           const Pyray& pyray, float finest_side,
                                                           std::size_t most) {
  search_.start(features, pyray.frame, nullptr, finest_side, pyray.bounds);
  HitLists& lists = search_.lists();
  scratch_.clear();
  segments_.clear();
  for (const std::uint32_t i : lists.root())
    if (!lists.resolve(i, pyray.square, 0.0f, most, scratch_)) return std::nullopt;
  for (const std::uint32_t i : scratch_) segments_.push_back(lists.segment(i));
  return segments_;
}

void Tracer::start(const FeatureSet& features, const Frame& frame, const SearchBounds& bounds,
                   const SubdivisionRules& rules, float root_side) {
  search_.start(features, frame, rules.variant, root_side * rules.finest_side(), bounds);
}

// Samples the centres of all pyrays, since each needs one: coherent rays, traced together. Sample
// number i belongs to pyray i.
void Tracer::look_through_middles(const FatPyray& fat, Caster& caster) {
  middles_.clear();
  for (int y = 0; y < fat.side; ++y) {
    for (int x = 0; x < fat.side; ++x) {
      const Square s = fat.square_of(x, y, 1);
      middles_.emplace_back(s.centre_u(), s.centre_v());
    }
  }
  (void)caster.probe(middles_);
  caster.middles_known(fat.side);
}

// Finds neighbours that show different surfaces without a boundary in either (design section 3).
void Tracer::find_missed_splits(const FatPyray& fat, const Caster& caster) {
  for (int y = 0; y < fat.rows; ++y) {
    for (int x = 0; x < fat.columns; ++x) {
      if (x + 1 < fat.columns) compare(fat, {x, y}, {x + 1, y}, caster);
      if (y + 1 < fat.rows) compare(fat, {x, y}, {x, y + 1}, caster);
    }
  }
}

void Tracer::compare(const FatPyray& fat, glm::ivec2 a, glm::ivec2 b, const Caster& caster) {
  const std::uint32_t i = fat.index(a.x, a.y), j = fat.index(b.x, b.y);
  if (fat_search_.bounded(i) || fat_search_.bounded(j) || caster.surface(i) == caster.surface(j))
    return;
  // A cut-out's outline is in its texture, which has no edges; the samples find it.
  traces_[i].by_samples = traces_[j].by_samples = true;
  if (caster.opaque(i) && caster.opaque(j) && !touches_boundary(fat, a, caster) &&
      !touches_boundary(fat, b, caster))
    traces_[i].missed = traces_[j].missed = true;
}

// Returns whether a boundary runs exactly along the border of a pyray, where it counts for neither
// side.
bool Tracer::touches_boundary(const FatPyray& fat, glm::ivec2 at, const Caster& caster) {
  const Square own = fat.square_of(at.x, at.y, 1);
  const float border = own.side / 256.0f;
  const Square wide{own.u - border, own.v - border, own.side + 2.0f * border};
  const CellOccluder hiding =
      CellOccluder::of(caster.cover(fat.index(at.x, at.y)), fat.frame, wide.side);
  search_.lists().refine(wide, hiding, search_.lists().root(), scratch_);
  return !search_.all_hidden(scratch_, {wide, hiding});
}

// Makes one leaf of each clear pyray. Pyrays with boundaries or uneven shading are subdivided
// together, and missed ones go to the safety net.
void Tracer::finish_roots(const FatPyray& fat, const SubdivisionRules& rules, Caster& caster,
                          std::uint32_t observed, TracedPyray* traced) {
  if (LensCaster* lens = caster.lens())
    return finish_lens_roots(fat, rules, caster, *lens, observed, traced);
  const int max_level = rules.error_budget.max_level;
  roots_.clear();
  for (int y = 0; y < fat.rows; ++y) {
    for (int x = 0; x < fat.columns; ++x) {
      const std::uint32_t i = fat.index(x, y);
      Root root{fat.square_of(x, y, 1), {}, i, i, fat.seed_of(x, y), nullptr};
      if (i == observed) root.traced = traced;
      // A bounded pyray is subdivided.
      if (fat_search_.bounded(i)) {
        root.list = fat_search_.list(i);
        roots_.push_back(root);
        continue;
      }
      // Split such a pyray by the safety net.
      if (traces_[i].by_samples && !caster.samples_leaf(i)) {
        traces_[i].outcome = split_by_samples(root, max_level, caster);
        continue;
      }
      // Subdivide a pyray without boundaries if its shading varies too much. Any other is one leaf.
      if (!finish_clear_root(root, max_level, caster)) roots_.push_back(root);
    }
  }
  // Subdivide all of them together.
  const auto done = subdivider_.run(search_, roots_, rules, caster);
  for (std::size_t k = 0; k < done.size(); ++k) traces_[roots_[k].id].outcome = done[k];
}

bool Tracer::finish_clear_root(const Root& root, int max_level, Caster& caster) {
  const std::uint32_t i = root.id;
  PyrayLeaf leaf{i, i, 1.0, {root.square, {}}};
  leaf.decision = caster.decide(leaf, max_level > 0);
  if (leaf.decision.splits()) return false;
  if (root.traced) {
    TracedCell& cell = root.traced->cells.emplace_back();
    if (caster.samples_leaf(i) || leaf.decision.sampled()) cell.fate = CellFate::sampled;
    cell.samples.push_back({i, glm::vec2(0.5f), 1.0, {}, {}});
  }
  caster.take(std::span(&leaf, 1));
  SubdivisionOutcome& outcome = traces_[i].outcome;
  outcome.pyrays_by_level[0] = 1;
  outcome.probes = 1;
  outcome.note_uneven(leaf.decision.cause);
  return true;
}

}  // namespace asos
