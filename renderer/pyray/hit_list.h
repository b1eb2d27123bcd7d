#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/frame.h"
#include "renderer/pyray/cover.h"
#include "renderer/pyray/flatten.h"
#include "renderer/pyray/node_test.h"
#include "renderer/pyray/search_bounds.h"
#include "renderer/pyray/square.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// Something that may bound what a cell shows: a boundary segment, or a node of the hierarchy that
/// has not been opened, with its rectangle in the root frame and its greatest nearness.
struct HitEntry {
  enum class Type : std::uint8_t { node, leaf, segment };

  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
  float nearness = 0;             ///< the greatest
  std::uint32_t ref = 0;          ///< node, first edge of a leaf, or segment
  std::uint32_t first_child = 0;  ///< the first entry made when it was opened
  std::uint32_t chain[2] = {FeatureEdge::none, FeatureEdge::none};  ///< see NodeChains
  float chain_deviation = 0.0f;
  std::uint32_t chord = FeatureEdge::none;  ///< the entry that stands for the chain, once made
  std::uint16_t child_count = 0;
  std::uint8_t edge_count = 0;  ///< of a leaf
  Type type = Type::node;
  bool opened = false;

  [[nodiscard]] bool is_segment() const { return type == Type::segment; }
  [[nodiscard]] bool is_chain() const { return chain[0] != FeatureEdge::none; }
  [[nodiscard]] float extent() const { return u1 - u0 > v1 - v0 ? u1 - u0 : v1 - v0; }
  [[nodiscard]] bool meets(const Square& s) const {
    return u0 < s.u + s.side && u1 > s.u && v0 < s.v + s.side && v1 > s.v;
  }
};

/// The boundaries that one root frame's pyray can meet: a part of the feature hierarchy, opened
/// lazily and projected at most once (design section 4; CGF'98 sections 6.1 and 6.3). A cell's hit
/// list is a cut through it, named by entry indices; children refine their parent's list only.
/// One object serves one root pyray at a time; `reset` reuses its memory.
class HitLists {
 public:
  using List = std::vector<std::uint32_t>;

  /// Starts a new root frame among `features`, which must outlive its use, as must what `bounds`
  /// points to. Nothing smaller than `finest_side` is ever opened for its size.
  void reset(const FeatureSet& features, const Frame& frame, float finest_side,
             const SearchBounds& bounds = {});

  /// A boundary that is no feature of the scene, straight from p to q. Nothing hides it: boundaries
  /// of the scene may be cut off where it runs, and would end in the open without it.
  void add_boundary(glm::vec2 p, glm::vec2 q);

  /// The list of the whole square: the hierarchy's root or the cut, not opened, and what was added.
  [[nodiscard]] const List& root() const { return root_; }
  /// The same without what was added.
  [[nodiscard]] std::span<const std::uint32_t> scene_root() const {
    return std::span(root_).first(scene_entries_);
  }

  /// The list of a cell from its parent's. Drops what misses the cell; opens a node while it is
  /// larger than a quarter of the cell, or while so few entries are left that the cell may turn out
  /// empty or crossed by one boundary. Entries that `hiding` hides are kept, but never opened.
  /// `seen`: `hiding` is the surface that a sample in the cell met, so that opening may stop once
  /// the cell is saturated with boundaries before it.
  void refine(const Square& cell, const HidingPlane& hiding, std::span<const std::uint32_t> parent,
              List& list, bool seen = false);

  /// Opens an entry all the way down, however small it is, and appends the segments below it that
  /// cross the cell; a chain that is straight within `tolerance`, in the frame, becomes one
  /// segment. False, with `list` as it happens to be, once it holds more than `limit`.
  [[nodiscard]] bool resolve(std::uint32_t i, const Square& cell, float tolerance,
                             std::size_t limit, List& list);

  [[nodiscard]] const HitEntry& entry(std::uint32_t i) const { return entries_[i]; }
  [[nodiscard]] const Segment& segment(const HitEntry& e) const { return segments_[e.ref]; }
  [[nodiscard]] const Segment& segment(std::uint32_t i) const { return segments_[entries_[i].ref]; }
  /// The sheets on both sides of a segment's edge (FeatureEdge::none: none there).
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> sheets(std::uint32_t i) const {
    if (segment(i).edge == FeatureEdge::none) return {FeatureEdge::none, FeatureEdge::none};
    const FeatureEdge edge = features_->edge(segment(i).edge);
    return {edge.left_sheet, edge.right_sheet};
  }
  /// The kind of a segment as seen in this frame: a crease or a seam whose two faces lie to the
  /// same side of it is a silhouette. Nothing for a boundary that is no feature of the scene.
  [[nodiscard]] std::optional<FeatureKind> kind(std::uint32_t i) const;
  /// The kind of a segment's edge as the scene has it; open where it is no edge of the scene.
  [[nodiscard]] FeatureKind feature(std::uint32_t i) const {
    return segment(i).edge == FeatureEdge::none ? FeatureKind::open
                                                : features_->edge(segment(i).edge).kind;
  }
  [[nodiscard]] const Frame& frame() const { return frame_; }
  /// Whether nodes stayed closed because the search had cost all that its bounds allow.
  [[nodiscard]] bool exhausted() const { return entries_.size() > bounds_.most_entries; }

  /// Whether an entry of a cell's list lies behind `hiding` wherever it crosses the cell.
  [[nodiscard]] bool hidden(std::uint32_t i, const Square& cell, const HidingPlane& hiding) const;

 private:
  void visit(std::uint32_t i, const Square& cell, const HidingPlane& hiding, List& list);
  [[nodiscard]] bool saturated() const;
  void open(std::uint32_t i);
  void open_node(std::uint32_t node, unsigned children);
  void open_leaf(std::uint32_t i);
  void add_curve(std::uint32_t edge);
  void add_segment(std::uint32_t edge, glm::dvec3 a, glm::dvec3 b);
  void keep_segment(const Segment& s);
  [[nodiscard]] bool straight(const HitEntry& e, float tolerance) const;
  [[nodiscard]] bool replace_by_chord(std::uint32_t i);

  const FeatureSet* features_ = nullptr;
  SearchBounds bounds_;
  List root_;
  std::size_t scene_entries_ = 0;  // the first of root_
  Frame frame_ = Frame::pyramid({0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0});
  NodeTestFrame test_frame_{frame_};
  float finest_side_ = 0.0f;
  // Of the list being refined, what may be seen: unopened nodes, and segments.
  struct InView {
    std::size_t nodes = 0;
    std::size_t segments = 0;
  };
  InView in_view_;
  bool stops_when_saturated_ = false;
  float squares_a_unit_ =
      1.0f;  // length in the square of a world unit across the view, at nearness 1
  std::vector<HitEntry> entries_;
  std::vector<Segment> segments_;
  Flattener flattener_;
};

}  // namespace asos
