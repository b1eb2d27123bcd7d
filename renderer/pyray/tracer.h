#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/pyray/boundary_search.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/fat_search.h"
#include "renderer/pyray/lens_caster.h"
#include "renderer/pyray/observer.h"
#include "renderer/pyray/pyray.h"
#include "renderer/pyray/rules.h"
#include "renderer/pyray/subdivide.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Statistics of a traced pyray.
struct Trace {
  SubdivisionOutcome outcome;
  bool by_samples = false;  ///< the safety net split the pyray
  bool missed = false;      ///< by_samples, because a boundary was missed
  bool timed_out = false;   ///< too many boundaries for its rules, or its caster gave up: no leaves
};

/// The central algorithm of this program: finds the boundaries that pass through a pyramid. Without
/// any, it takes one sample; else it splits the pyramid (CGF'98 section 3; design section 1).
/// Pixels of a block, shadows of all lights, and reflections all use it, with their own frame,
/// rules and caster. One object per thread and depth of nesting; reuses its memory and holds no
/// result.
class Tracer {
 public:
  /// Passes the pyray's leaves to the caster. `traced` records its subdivision, or is null.
  Trace trace(const FeatureSet& features, const Pyray& pyray, const SubdivisionRules& rules,
              Caster& caster, TracedPyray* traced = nullptr);

  /// Traces the pyrays of a fat one within its columns and rows, in `index` order; root numbers are
  /// indices. Records pyray `observed` in `traced`. The result is valid until the next trace.
  std::span<const Trace> trace(const FeatureSet& features, const FatPyray& fat,
                               const SubdivisionRules& rules, Caster& caster,
                               std::uint32_t observed = 0, TracedPyray* traced = nullptr);

  /// The first half of a single pyray's trace: begins the search. Returns whether any boundary of
  /// the scene may pass through it, hidden or not.
  bool search(const FeatureSet& features, const Pyray& pyray, const SubdivisionRules& rules);
  /// The second half, with additional outlines.
  Trace trace_searched(const Pyray& pyray, std::span<const BorderEdge> outline,
                       const SubdivisionRules& rules, Caster& caster, TracedPyray* traced);

  /// Returns every boundary of the scene that passes through a pyray, down to the smallest; curves
  /// are flattened for cells of `finest_side`. Returns nothing if there are more than `most`. Valid
  /// until the next trace.
  [[nodiscard]] std::optional<std::span<const Segment>> boundaries(const FeatureSet& features,
                                                                   const Pyray& pyray,
                                                                   float finest_side,
                                                                   std::size_t most);

 private:
  void start(const FeatureSet& features, const Frame& frame, const SearchBounds& bounds,
             const SubdivisionRules& rules, float root_side);
  void look_through_middles(const FatPyray& fat, Caster& caster);
  void find_missed_splits(const FatPyray& fat, const Caster& caster);
  void compare(const FatPyray& fat, glm::ivec2 a, glm::ivec2 b, const Caster& caster);
  [[nodiscard]] bool touches_boundary(const FatPyray& fat, glm::ivec2 at, const Caster& caster);
  void finish_roots(const FatPyray& fat, const SubdivisionRules& rules, Caster& caster,
                    std::uint32_t observed, TracedPyray* traced);
  /// Makes a root without boundaries one leaf. Returns false if the root has to be subdivided
  /// instead.
  bool finish_clear_root(const Root& root, int max_level, Caster& caster);
  void finish_lens_roots(const FatPyray& fat, const SubdivisionRules& rules, Caster& caster,
                         LensCaster& lens, std::uint32_t observed, TracedPyray* traced);
  void finish_lens_root(Root root, Caster& caster, LensCaster& lens, int max_level);
  [[nodiscard]] bool crosses(const Root& root, const Caster& caster);
  void sample_lens_root(const Root& root, LensCaster& lens);
  void drop_blurred_roots(const SubdivisionRules& rules, LensCaster& lens);

  BoundarySearch search_;
  Subdivider subdivider_;
  FatSearch fat_search_;
  BoundarySearch::List list_;
  BoundarySearch::List scratch_;
  std::vector<glm::vec2> middles_;
  std::vector<Root> roots_;
  std::vector<Root> crossed_;                     // sharp roots with boundaries
  std::vector<BoundarySearch::List> lens_lists_;  // by root; with depth of field
  std::vector<Trace> traces_;
  std::vector<Segment> segments_;
};

}  // namespace asos
