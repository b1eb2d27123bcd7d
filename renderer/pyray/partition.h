#pragma once

#include "renderer/pyray/partition_pieces.h"
#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// One part of a cell between its boundary lines. It is uniform if the cell has no other
/// boundaries.
struct CellPart {
  double area = 0.0;  ///< fraction of the cell, 0 to 1
  float u = 0.0f;     ///< a point well inside it, in the root frame
  float v = 0.0f;
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;  ///< its bounding rectangle
  std::uint32_t first_edge = 0;          ///< the first of its sides, which are consecutive
  std::uint32_t edge_count = 0;
};

/// Cuts a cell along the boundary segments that cross it, with exact areas ("exact leaf"). CGF'98
/// sections 6.2 and 6.4 mention it for a single edge. This is the planar arrangement of any few
/// segments: lines, chains, corners, junctions, crossings, slivers and islands. A line that ends
/// slightly before the next one is extended to it. Such gaps occur where lines of one corner were
/// found in different ways, as in curved mirrors or at a leaf's own outline. Uses double precision
/// in cell units; reuses its memory; one object per thread.
class CellPartition {
 public:
  /// Returns the parts, whose areas add up to 1. Returns nothing if there are too many lines for
  /// `max_parts`, or they are too degenerate; then the cell has to be subdivided.
  [[nodiscard]] std::span<const CellPart> cut(const Square& cell, std::span<const Segment> segments,
                                              std::size_t max_parts);

  /// Returns all sides of the last parts, in the root frame.
  [[nodiscard]] std::span<const BorderEdge> borders() const { return borders_; }

 private:
  using Edge = PartitionEdge;
  using Piece = PartitionPiece;
  struct Spoke {
    std::uint32_t node;
    double angle;
    std::uint32_t half_edge;
  };
  struct Loop {
    std::uint32_t first = 0;  // into loop_nodes_
    std::uint32_t count = 0;
    double area = 0.0;  // positive: the outer border of a part
    std::uint32_t component = 0;
    std::int32_t part = -1;
  };

  bool cut_by_one();
  bool cut_by_many(std::size_t max_parts);
  bool add_piece(const Segment& s);
  void add_speck(glm::dvec2 p);
  [[nodiscard]] std::uint32_t node_at(glm::dvec2 p);
  void split_pieces();
  void add_border();
  void add_edge(std::uint32_t a, std::uint32_t b);
  bool trace_loops(std::size_t max_parts);
  bool make_parts(std::size_t max_parts);
  [[nodiscard]] bool inside(const Loop& loop, glm::dvec2 p) const;
  [[nodiscard]] bool inside_part(std::int32_t part, glm::dvec2 p) const;
  bool place_sample(std::int32_t part, const Loop& outer);
  void find_crossings(std::int32_t part, double y);
  [[nodiscard]] double clearance(std::int32_t part, glm::dvec2 p) const;
  template <typename Visit>
  void for_each_edge(const Loop& loop, Visit&& visit) const {
    for (std::uint32_t k = 0; k < loop.count; ++k)
      visit(nodes_[loop_nodes_[loop.first + k]],
            nodes_[loop_nodes_[loop.first + (k + 1) % loop.count]]);
  }
  void emit_edge(glm::dvec2 from, glm::dvec2 to);
  void emit(double area, glm::dvec2 at, glm::dvec2 lo, glm::dvec2 hi, std::size_t first_edge);

  Square cell_;
  std::vector<Piece> pieces_;
  std::vector<glm::dvec2> specks_;  // places of pieces that are too short to be boundaries
  std::vector<glm::dvec2> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> component_;
  std::vector<Loop> loops_;
  std::vector<std::uint32_t> loop_nodes_;
  std::vector<CellPart> parts_;
  std::vector<BorderEdge> borders_;
  std::vector<double> crossings_;
  std::vector<std::pair<double, std::uint32_t>> order_;
  std::vector<Spoke> around_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint8_t> visited_;
};

}  // namespace asos
