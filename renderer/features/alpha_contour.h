#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// A square of a texture's plane between four neighbouring texels' centres, some of which are cut
/// out and some not. Coordinates in texels, whose centres lie at whole numbers; beyond a texture
/// that is clamped to its edge a cell is as long as was asked for.
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

/// Coordinates in texels of places that texture coordinates name: (u, v) times the image's size,
/// less half a texel, and not wrapped.
[[nodiscard]] glm::dvec2 texel_place(const Image& image, glm::dvec2 uv);

/// The curve at which a texture's alpha, times a factor, is the cut-off, all over the plane of its
/// coordinates: with linear filtering of the four nearest texels, level 0 (glTF 2.0 section 3.9.4,
/// "alphaMode" MASK; 3.8.4, samplers), an arc of a hyperbola in each cell between four texels'
/// centres, which marching squares find (Lorensen and Cline 1987; crossings in one cell told apart
/// by Nielson and Hamann 1991, "The asymptotic decider"); with the nearest texel, texels' sides.
/// The image has to outlive it. Immutable, thread-safe.
class AlphaContour {
 public:
  AlphaContour(const Image& image, const Texture& sampler, float factor, float cutoff);

  /// There is no such curve: all of the plane is cut out, or nothing is.
  [[nodiscard]] bool empty() const { return columns_.empty(); }
  /// The curve is so long that it was not looked for to its end; nothing may be asked of it.
  [[nodiscard]] bool endless() const { return endless_; }

  /// Whether a place of the plane is not cut out.
  [[nodiscard]] bool keeps(glm::dvec2 place) const;

  /// The rows of cells that meet the heights from y0 to y1: the first, and one past the last.
  struct Rows {
    std::int64_t first = 0;
    std::int64_t end = 0;
  };
  [[nodiscard]] Rows rows(double y0, double y1) const;
  /// A bound on how many cells `find_cells` finds and what it takes to look for them.
  [[nodiscard]] std::size_t most_cells(std::int64_t row, double x0, double x1) const;

  /// Appends the cells of a row between x0 and x1 that the curve passes through, in order. `y0` and
  /// `y1`: the heights that were asked for.
  void find_cells(std::int64_t row, double x0, double x1, double y0, double y1,
                  std::vector<ContourCell>& cells) const;

  /// Appends the pieces of the curve through a cell, none farther than `tolerance` (in texels) from
  /// it. Ends on a cell's border, and those of one arc's neighbours, are equal to the bit.
  void find_pieces(const ContourCell& cell, double tolerance,
                   std::vector<ContourPiece>& pieces) const;

 private:
  /// One direction of the plane: cells from texel i to i + 1, for whole numbers i of any size.
  struct Axis {
    Wrap wrap = Wrap::repeat;
    std::int64_t size = 0;  ///< texels

    /// Cells after which all is repeated; of clamped ones all there are.
    [[nodiscard]] std::int64_t period() const;
    [[nodiscard]] std::int64_t cell_at(double x) const;
    [[nodiscard]] std::int64_t in_period(std::int64_t cell) const;
    [[nodiscard]] std::int64_t texel(std::int64_t i) const;
    /// Where a cell begins and ends, if the interval [x0, x1] was asked for.
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
