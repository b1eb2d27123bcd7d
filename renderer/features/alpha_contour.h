#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// A square of a texture's plane between the centres of four neighbouring texels, where some texels
/// are cut out and others are not. Coordinates are in texels, with centres at whole numbers. Beyond
/// the edge of a clamped texture, a cell is as long as the requested interval.
struct ContourCell {
  glm::dvec2 lo{0.0};
  glm::dvec2 hi{1.0};
  /// Alpha minus the cut-off at (lo, lo), (hi, lo), (lo, hi), (hi, hi); at least 0: not cut out.
  std::array<double, 4> value{};
};

/// A straight piece of a contour.
struct ContourPiece {
  glm::dvec2 from;
  glm::dvec2 to;
};

/// Converts texture coordinates to texels: (u, v) times the image's size, less half a texel, and
/// not wrapped.
[[nodiscard]] glm::dvec2 texel_place(const Image& image, glm::dvec2 uv);

/// The curve in the plane of a texture's coordinates at which alpha, times a factor, equals the
/// cut-off. With linear filtering of the four nearest texels, level 0 (glTF 2.0 section 3.9.4,
/// "alphaMode" MASK; 3.8.4, samplers), it is an arc of a hyperbola in each cell between four
/// texels' centres. Marching squares find the arcs (Lorensen and Cline 1987); crossings in one cell
/// are resolved by Nielson and Hamann 1991, "The asymptotic decider". With nearest filtering, it
/// follows the texels' sides. The image has to outlive it. Immutable, thread-safe.
class AlphaContour {
 public:
  AlphaContour(const Image& image, const Texture& sampler, float factor, float cutoff);

  /// Returns whether there is no such curve, because everything is cut out, or nothing is.
  [[nodiscard]] bool empty() const { return columns_.empty(); }
  /// Returns whether the curve is so long that the search was given up. Then nothing else may be
  /// called.
  [[nodiscard]] bool endless() const { return endless_; }

  /// Returns whether a place of the plane is not cut out.
  [[nodiscard]] bool keeps(glm::dvec2 place) const;

  /// The rows of cells between the heights y0 and y1: the first, and one past the last.
  struct Rows {
    std::int64_t first = 0;
    std::int64_t end = 0;
  };
  [[nodiscard]] Rows rows(double y0, double y1) const;
  /// Returns a bound on the number of cells that `find_cells` finds and visits.
  [[nodiscard]] std::size_t most_cells(std::int64_t row, double x0, double x1) const;

  /// Appends the cells of a row between x0 and x1 that the curve passes through, in order. `y0` and
  /// `y1` are the requested heights.
  void find_cells(std::int64_t row, double x0, double x1, double y0, double y1,
                  std::vector<ContourCell>& cells) const;

  /// Appends the pieces of the curve through a cell, with a distance from it of at most `tolerance`
  /// (in texels). Ends on a cell's border, and ends of neighbouring pieces of one arc, are equal
  /// bit for bit.
  void find_pieces(const ContourCell& cell, double tolerance,
                   std::vector<ContourPiece>& pieces) const;

 private:
  /// One direction of the plane: cells from texel i to i + 1, for any whole number i.
  struct Axis {
    Wrap wrap = Wrap::repeat;
    std::int64_t size = 0;  ///< texels

    /// Returns the number of cells after which the texture repeats; for a clamped one, the number
    /// of all cells.
    [[nodiscard]] std::int64_t period() const;
    [[nodiscard]] std::int64_t cell_at(double x) const;
    [[nodiscard]] std::int64_t in_period(std::int64_t cell) const;
    [[nodiscard]] std::int64_t texel(std::int64_t i) const;
    /// Returns where a cell begins and ends, for the requested interval [x0, x1].
    [[nodiscard]] glm::dvec2 extent(std::int64_t cell, double x0, double x1) const;
  };

  [[nodiscard]] double value(std::int64_t x, std::int64_t y) const;
  void find_mixed_cells();

  const Image* image_;
  Axis across_, down_;
  bool nearest_ = false;
  bool endless_ = false;
  std::array<double, 256> value_of_{};  // alpha minus the cut-off, by the texel's byte
  // The cells of a period that the curve passes through, row by row.
  std::vector<std::uint32_t> first_of_row_;
  std::vector<std::int32_t> columns_;
};

}  // namespace asos
