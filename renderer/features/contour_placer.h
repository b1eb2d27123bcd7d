#pragma once

#include "renderer/features/alpha_contour.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asos {

/// A triangle with the places of its corners in a texture's plane, in texels.
struct TexturedTriangle {
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec2, 3> texels;

  /// Its corners lie on a line of the texture, to rounding, or in one place.
  [[nodiscard]] bool flat_in_texture() const;
};

/// Places the curve of a texture's plane on triangles that show it. Keeps its memory; one object a
/// thread.
class ContourPlacer {
 public:
  struct Line {
    glm::vec3 from;
    glm::vec3 to;
  };

  /// Appends the pieces of the curve that lie in the triangle, which is not flat in its texture, in
  /// world coordinates. Lines of one curve that meet, in a triangle or at a side that two of them
  /// share with both its texture coordinates, have the same ends to the bit. `looks` is lessened by
  /// what was looked at. False where `looks` or `most_lines` did not suffice.
  [[nodiscard]] bool place(const TexturedTriangle& triangle, const AlphaContour& contour,
                           double tolerance, std::size_t most_lines, std::size_t& looks,
                           std::vector<Line>& lines);

  /// Whether all between two places of the texture is cut out. False where `looks` did not suffice
  /// to tell.
  [[nodiscard]] bool hides(glm::dvec2 p, glm::dvec2 q, const AlphaContour& contour,
                           std::size_t& looks);

  /// Whether the curve comes near the triangle at all: true where `looks` did not suffice to tell.
  [[nodiscard]] bool comes_near(const TexturedTriangle& triangle, const AlphaContour& contour,
                                std::size_t& looks);

 private:
  /// A side of the triangle, directed so that neighbours direct it alike.
  struct Side {
    glm::dvec2 lo, along;
    glm::dvec3 lo_position, along_position;
    bool inside_is_left = false;

    [[nodiscard]] double height(glm::dvec2 p) const;
    [[nodiscard]] glm::vec3 placed(glm::dvec2 p) const;
  };
  /// An end of what is left of a piece, and the side that it lies on, if any.
  struct End {
    glm::dvec2 at;
    const Side* side = nullptr;
  };

  template <typename VisitCell>
  [[nodiscard]] bool visit_cells(const TexturedTriangle& triangle, const AlphaContour& contour,
                                 std::size_t& looks, VisitCell visit);
  void set_sides(const TexturedTriangle& triangle);
  [[nodiscard]] std::optional<Line> clipped(const ContourPiece& piece) const;
  [[nodiscard]] glm::vec3 placed(const End& end) const;

  std::array<Side, 3> sides_;
  glm::dvec2 origin_{0.0};
  glm::dmat2 weights_{1.0};  // barycentric coordinates from places in texels
  glm::dvec3 corner_{0.0}, edge1_{0.0}, edge2_{0.0};
  std::vector<ContourCell> cells_;  // of a row
  std::vector<ContourPiece> pieces_;
};

}  // namespace asos
