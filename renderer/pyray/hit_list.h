#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/frame.h"
#include "renderer/pyray/flatten.h"
#include "renderer/pyray/node_test.h"
#include "renderer/pyray/occluder_plane.h"
#include "renderer/pyray/search_bounds.h"
#include "renderer/pyray/square.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// A possible boundary of a cell: a segment, or an unopened node of the hierarchy, with its
/// rectangle in the root frame and its greatest nearness.
struct HitEntry {
  enum class Type : std::uint8_t { node, leaf, segment };

  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
  float nearness = 0;             ///< the largest one
  std::uint32_t ref = 0;          ///< node, first edge of a leaf, or segment
  std::uint32_t first_child = 0;  ///< first of the entries made by opening
  std::uint32_t chain[2] = {FeatureEdge::none, FeatureEdge::none};  ///< see NodeChains
  float chain_deviation = 0.0f;
  std::uint32_t chord = FeatureEdge::none;  ///< the entry that represents the chain, once made
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

/// The boundaries that can meet one root frame's pyray: a part of the feature hierarchy, opened
/// lazily and projected at most once (design section 4; CGF'98 sections 6.1 and 6.3). A cell's hit
/// list is a cut through it, as entry indices; children refine their parent's list only. One object
/// serves one root pyray at a time; `reset` reuses its memory.
class HitLists {
 public:
  using List = std::vector<std::uint32_t>;

  /// Starts a new root frame among `features`. These must outlive its use, and so must the data of
  /// `bounds`. Nothing smaller than `finest_side` is opened because of its size.
  void reset(const FeatureSet& features, const Frame& frame, float finest_side,
             const SearchBounds& bounds = {});

  /// Adds a straight boundary from p to q that is no feature of the scene. It is never hidden:
  /// boundaries of the scene may be cut off along it and would have open ends without it.
  void add_boundary(glm::vec2 p, glm::vec2 q);

  /// Returns the list of the whole square: the unopened root of the hierarchy or the cut, and the
  /// added boundaries.
  [[nodiscard]] const List& root() const { return root_; }
  /// Returns that list without the added boundaries.
  [[nodiscard]] std::span<const std::uint32_t> scene_root() const {
    return std::span(root_).first(scene_entries_);
  }

  /// Computes the list of a cell from its parent's. It drops entries outside of the cell. It opens
  /// nodes larger than a quarter of the cell, and nodes in short lists, where the cell may turn out
  /// empty or crossed by one boundary. Entries hidden by `hiding` are kept, but never opened.
  /// `seen` says that `hiding` is the surface of a sample in the cell, so that opening may stop
  /// once the cell is saturated with boundaries in front of it.
  void refine(const Square& cell, const CellOccluder& hiding, std::span<const std::uint32_t> parent,
              List& list, bool seen = false);

  /// Opens an entry completely, whatever its size, and appends the segments below it that cross the
  /// cell. A chain that is straight within `tolerance`, in the frame, becomes one segment. Returns
  /// false, with an incomplete `list`, once it has more than `limit` entries.
  [[nodiscard]] bool resolve(std::uint32_t i, const Square& cell, float tolerance,
                             std::size_t limit, List& list);

  [[nodiscard]] const HitEntry& entry(std::uint32_t i) const { return entries_[i]; }
  [[nodiscard]] const Segment& segment(const HitEntry& e) const { return segments_[e.ref]; }
  [[nodiscard]] const Segment& segment(std::uint32_t i) const { return segments_[entries_[i].ref]; }
  /// Returns the smooth surfaces on both sides of a segment's edge (FeatureEdge::none: none there).
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> smooth_surfaces(std::uint32_t i) const {
    if (segment(i).edge == FeatureEdge::none) return {FeatureEdge::none, FeatureEdge::none};
    const FeatureEdge edge = features_->edge(segment(i).edge);
    return {edge.left_surface, edge.right_surface};
  }
  /// Returns the kind of a segment in this frame. A crease or a seam whose two faces lie on the
  /// same side of it is a silhouette. Returns nothing for a boundary that is no feature of the
  /// scene.
  [[nodiscard]] std::optional<FeatureKind> kind(std::uint32_t i) const;
  /// Returns the kind of a segment's edge in the scene; open if it is no edge of the scene.
  [[nodiscard]] FeatureKind feature(std::uint32_t i) const {
    return segment(i).edge == FeatureEdge::none ? FeatureKind::open
                                                : features_->edge(segment(i).edge).kind;
  }
  [[nodiscard]] const Frame& frame() const { return frame_; }
  /// Returns whether nodes stayed closed because the search reached SearchBounds::most_entries.
  [[nodiscard]] bool exhausted() const { return entries_.size() > bounds_.most_entries; }

  /// Returns whether an entry of a cell's list lies behind `hiding` everywhere in the cell.
  [[nodiscard]] bool hidden(std::uint32_t i, const Square& cell, const CellOccluder& hiding) const;

 private:
  void visit(std::uint32_t i, const Square& cell, const CellOccluder& hiding, List& list);
  [[nodiscard]] bool too_many_boundaries() const;
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
  std::size_t scene_entries_ = 0;  // the first ones of root_
  Frame frame_ = Frame::pyramid({0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0});
  NodeTestFrame test_frame_{frame_};
  float finest_side_ = 0.0f;
  // Possibly visible entries of the list that is being refined: unopened nodes, and segments.
  struct InView {
    std::size_t nodes = 0;
    std::size_t segments = 0;
  };
  InView in_view_;
  bool stops_at_too_many_ = false;
  // Length in the square of a world unit across the view, at nearness 1.
  float squares_a_unit_ = 1.0f;
  std::vector<HitEntry> entries_;
  std::vector<Segment> segments_;
  Flattener flattener_;
};

}  // namespace asos
