#pragma once

#include "renderer/features/alpha_contour.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace asos {

/// A triangle with its corners' places in a texture's plane, in texels.
struct TexturedTriangle {
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec2, 3> texels;

  /// Returns whether its corners are on a line of the texture, up to rounding, or at the same
  /// place.
  [[nodiscard]] bool flat_in_texture() const;
};

/// Places the curve of a texture's plane on triangles with that texture. Reuses its memory; one
/// object per thread.
class ContourPlacer {
 public:
  struct Line {
    glm::vec3 from;
    glm::vec3 to;
  };

  /// Appends the pieces of the curve inside the triangle, in world coordinates. The triangle must
  /// not be flat in its texture. Lines of one curve that meet have equal ends, bit for bit: inside
  /// a triangle, or at a side that two triangles share with the same texture coordinates. A bound
  /// on the visited rows and cells is subtracted from `looks`. Returns false if `looks` or
  /// `most_lines` did not suffice.
  [[nodiscard]] bool place(const TexturedTriangle& triangle, const AlphaContour& contour,
                           double tolerance, std::size_t most_lines, std::size_t& looks,
                           std::vector<Line>& lines);

  /// Returns whether everything between two places of the texture is cut out. Returns false if
  /// `looks` did not suffice.
  [[nodiscard]] bool hides(glm::dvec2 p, glm::dvec2 q, const AlphaContour& contour,
                           std::size_t& looks);

  /// Returns whether the curve comes near the triangle at all, or `looks` did not suffice.
  [[nodiscard]] bool comes_near(const TexturedTriangle& triangle, const AlphaContour& contour,
                                std::size_t& looks);

 private:
  /// A side of the triangle, with a direction that is the same for both triangles that share it.
  struct Side {
    glm::dvec2 lo, along;
    glm::dvec3 lo_position, along_position;
    bool inside_is_left = false;

    [[nodiscard]] double height(glm::dvec2 p) const;
    [[nodiscard]] glm::vec3 placed(glm::dvec2 p) const;
  };
  /// An end of a clipped piece, and the side on which it lies, if any.
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
  glm::dmat2 weights_{1.0};  // maps places in texels to barycentric coordinates
  glm::dvec3 corner_{0.0}, edge1_{0.0}, edge2_{0.0};
  std::vector<ContourCell> cells_;  // of a row
  std::vector<ContourPiece> pieces_;
};

}  // namespace asos
