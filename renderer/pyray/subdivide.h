#pragma once

#include "renderer/pyray/caster.h"
#include "renderer/pyray/chains.h"
#include "renderer/pyray/detection.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/partition.h"
#include "renderer/pyray/square.h"
#include "renderer/pyray/stopping.h"
#include "renderer/pyray/subdivision_trace.h"
#include "renderer/settings/settings.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// How far the engine goes to cut a cell instead of splitting it. The defaults suit pixels, of
/// which there are many and whose children are cheap; a light is looked at once, from afar, and its
/// parts cost a ray each.
struct LeafLimits {
  int least_faces = 16;      ///< parts that are allowed at any level
  int most_groups = 8;       ///< groups of boundaries that are told apart at all
  int most_boundaries = 12;  ///< edges, or chains of edges
  int most_pieces = 32;      ///< straight pieces of a few chains
  /// Of chains, in roots; 0: a 64th of a finest cell, and less in larger ones.
  float tolerance = 0.0f;
};

/// When to stop and how to sample (CGF'98 section 3.1; design section 5).
struct SubdivisionRules {
  int max_level = 3;  ///< MAX, 0 to max_level_limit
  double eps = 0.0;   ///< EPS: allowed change of a root's value, 0 to 1
  StoppingRule rule = StoppingRule::unresolved;
  Detection detection = Detection::square;
  bool exact_leaves = true;  ///< cut cells along their boundaries; false: point leaves
  bool jitter = false;       ///< jitter the samples of cells that stay marginal at MAX
  LeafLimits limits;
};

/// A pyray to subdivide: a square of the frame, and the boundaries that pass through it.
struct Root {
  Square square;
  std::span<const std::uint32_t> list;          ///< hit list of what the detection reaches
  Caster::SampleId centre = Caster::no_sample;  ///< at the square's centre, if known
  std::uint32_t id = 0;                         ///< passed on to Caster::leaf
  std::uint64_t seed = 0;                       ///< for jitter
};

/// Kinds of boundaries, a bit for each FeatureKind.
class BoundaryKinds {
 public:
  void add(FeatureKind kind) { bits_ = static_cast<std::uint8_t>(bits_ | bit(kind)); }
  void add(BoundaryKinds other) { bits_ = static_cast<std::uint8_t>(bits_ | other.bits_); }
  [[nodiscard]] bool has(FeatureKind kind) const { return (bits_ & bit(kind)) != 0; }
  [[nodiscard]] bool empty() const { return bits_ == 0; }

 private:
  [[nodiscard]] static std::uint8_t bit(FeatureKind kind) {
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
  }
  std::uint8_t bits_ = 0;
};

/// What a root's subdivision came to.
struct SubdivisionOutcome {
  int deepest = 0;               ///< finest level examined; a cut counts as one more
  double unresolved_area = 0.0;  ///< share of the root whose cells stayed marginal
  bool uneven_shading = false;   ///< some cell was split for its shading alone
  bool uneven_shadow = false;    ///< some cell was split for a shadow on it alone
  bool saturated = false;        ///< some cell went to its finest samples at once
  bool at_limit = false;         ///< cells stayed marginal at MAX and the rule did not hold
  /// Of the boundaries that were visible in cells that were cut or stayed marginal to the end;
  /// groups of edges that were not told apart there count as silhouettes.
  BoundaryKinds boundaries;
  std::array<std::uint32_t, max_level_limit + 1> pyrays_by_level{};
};

/// The one subdivision routine, for every kind of pyray: splits squares level by level where
/// boundaries pass through them, until no cell is marginal, the rule holds, or MAX is reached.
/// Roots of one frame go together, so that their rays can go in packets; none influences another.
/// Reuses its memory; one object a thread.
class Subdivider {
 public:
  /// Records the subdivision of the root whose id is `root_id` during the next `run`.
  void trace(std::uint32_t root_id, SubdivisionTrace& into);

  /// One outcome a root. The weights of each root's leaves add up to 1, unless the caster was
  /// cancelled.
  std::span<const SubdivisionOutcome> run(HitLists& lists, std::span<const Root> roots,
                                          const SubdivisionRules& rules, Caster& caster);

 private:
  using SampleId = Caster::SampleId;

  struct Cell {
    Square square;
    std::uint32_t root = 0;
    std::uint32_t first = 0;  // of its list, in the level's entries
    std::uint32_t count = 0;
    Cover cover;  // of a sample in the cell's closure
    SampleId centre = Caster::no_sample;
    bool fresh = false;  // its centre was sampled in this level's first round
    bool done = false;
    bool nothing_hides = false;            // what a sample hid is seen elsewhere in the cell
    Unevenness uneven = Unevenness::none;  // but for which it would be resolved

    [[nodiscard]] bool is_uneven() const { return uneven != Unevenness::none; }
  };
  struct Level {
    std::vector<Cell> cells;
    std::vector<std::uint32_t> entries;
    [[nodiscard]] std::span<const std::uint32_t> list(const Cell& cell) const {
      return std::span(entries).subspan(cell.first, cell.count);
    }
  };
  // Samples that a cell waits for, and what becomes of it when they are there.
  struct Plan {
    enum class Kind : std::uint8_t { uniform, faces, centre, saturated };
    Kind kind = Kind::centre;
    std::uint32_t cell = 0;
    std::uint32_t first_point = 0;
    std::uint32_t first_face = 0;
    std::uint32_t count = 0;
    Caster::TakenOver taken_over;
    std::uint32_t first_excluded = 0;  // entries taken for hidden
    std::uint32_t excluded_count = 0;
    BoundaryKinds boundaries;
  };

  void start(std::span<const Root> roots);
  // What can be resolved (subdivide_leaves.cpp).
  void resolve(Level& level);
  void plan(const Level& level, std::uint32_t cell_index, bool with_own_sample);
  void find_visible(std::span<const std::uint32_t> list, const Square& reach,
                    const HidingPlane& hiding);
  [[nodiscard]] bool plan_faces(const Level& level, std::uint32_t cell_index,
                                const HidingPlane& hiding);
  [[nodiscard]] std::span<const Face> cut(const Cell& cell, const HidingPlane& hiding);
  [[nodiscard]] float tolerance(const Cell& cell) const;
  [[nodiscard]] bool tell_apart(const Cell& cell, const HidingPlane& hiding);
  [[nodiscard]] bool plan_saturated(const Cell& cell, std::uint32_t cell_index);
  void add_plan(Plan::Kind kind, std::uint32_t cell_index, std::span<const glm::vec2> points);
  void carry_out(Level& level);
  [[nodiscard]] BoundaryKinds kinds_of(std::span<const std::uint32_t> entries) const;
  void find_boundaries(const Level& level, const Cell& cell);
  [[nodiscard]] Unevenness uneven(const Cell& cell, const Plan& plan, SampleId first) const;
  void take_leaf(const Cell& cell, SampleId sample, glm::vec2 at, double share,
                 const LeafRegion& region, TracedCell* seen);
  [[nodiscard]] bool excluded_stay_hidden(const Cell& cell, const Plan& plan, SampleId first) const;
  // What stays marginal.
  void stop_roots(Level& level);
  void tally(const Level& level, std::span<const Cell> cells);
  void finish_marginal(Level& level);
  void split(const Level& level, Level& next);
  [[nodiscard]] bool traced(const Cell& cell) const;
  TracedCell* record(const Level& level, const Cell& cell, CellFate fate);

  [[nodiscard]] double weight(const Cell& cell) const;
  [[nodiscard]] std::size_t most_faces() const;
  [[nodiscard]] glm::vec2 jittered(std::uint32_t root, const Square& s) const;
  SubdivisionOutcome& outcome(const Cell& cell) { return outcomes_[cell.root]; }

  HitLists* hits_ = nullptr;
  Caster* caster_ = nullptr;
  SubdivisionRules rules_;
  std::optional<Detector> detector_;
  std::span<const Root> roots_;
  int level_ = 0;
  std::vector<SubdivisionOutcome> outcomes_;
  Level levels_[2];
  HitLists::List list_;
  CellPartition partition_;
  ChainSimplifier chains_;
  std::vector<std::uint32_t> visible_;
  std::vector<std::uint32_t> told_apart_;     // what was visible_, without clusters
  std::span<const std::uint32_t> cut_along_;  // visible_ or told_apart_, of the cell cut last
  std::vector<Segment> segments_;
  std::size_t boundary_count_ = 0;  // of the cell looked at last: chains, where those are known
  LevelTally tally_;
  std::vector<std::uint32_t> near_;  // objects
  SubdivisionTrace* trace_ = nullptr;
  std::uint32_t traced_root_ = 0;
  std::vector<Plan> plans_;
  std::vector<glm::vec2> points_;
  std::vector<Face> faces_;
  std::vector<Side> sides_;  // of the faces
  std::vector<std::uint32_t> excluded_;
};

}  // namespace asos
