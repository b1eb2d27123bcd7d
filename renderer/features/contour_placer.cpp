#include "renderer/features/contour_placer.h"

#include "renderer/geometry/cross.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace asos {
namespace {

// Least area of a triangle in texture coordinates, which are floats, relative to its extent. A
// smaller one counts as a line.
constexpr double least_area = 1e-7;
// Beyond this, floats cannot resolve single texels.
constexpr double farthest_texel = 1e9;

struct Range {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void grow(double x) { lo = std::min(lo, x), hi = std::max(hi, x); }
  [[nodiscard]] bool empty() const { return lo > hi; }
};

Range heights_of(const TexturedTriangle& triangle) {
  Range range;
  for (const glm::dvec2& p : triangle.texels) range.grow(p.y);
  return range;
}

// Returns the triangle's horizontal range between two heights.
Range width_between(const TexturedTriangle& triangle, double y0, double y1) {
  Range range;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 p = triangle.texels[k], q = triangle.texels[(k + 1) % 3];
    if (p.y >= y0 && p.y <= y1) range.grow(p.x);
    for (const double y : {y0, y1})
      if ((p.y < y) != (q.y < y)) range.grow(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
  }
  return range;
}

}  // namespace

bool TexturedTriangle::flat_in_texture() const {
  const glm::dvec2 a = texels[1] - texels[0], b = texels[2] - texels[0];
  const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a)});
  return !(std::abs(cross(a, b)) > least_area * longest);
}

// Returns the signed distance to the side, times its length; negative on its left, since y points
// downwards.
double ContourPlacer::Side::height(glm::dvec2 p) const {
  return cross(along, p - lo);
}

glm::vec3 ContourPlacer::Side::placed(glm::dvec2 p) const {
  const double t = std::clamp(glm::dot(p - lo, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::vec3(lo_position + t * along_position);
}

// Visits the cells near the triangle, row by row, while `visit` returns true. Returns false if it
// does not, or if `looks` did not suffice.
template <typename VisitCell>
bool ContourPlacer::visit_cells(const TexturedTriangle& triangle, const AlphaContour& contour,
                                std::size_t& looks, VisitCell visit) {
  for (const glm::dvec2& p : triangle.texels)
    if (!(std::abs(p.x) < farthest_texel && std::abs(p.y) < farthest_texel)) return false;
  if (contour.empty()) return true;
  const Range high = heights_of(triangle);
  const AlphaContour::Rows rows = contour.rows(high.lo, high.hi);
  for (std::int64_t row = rows.first; row < rows.end; ++row) {
    // The first and the last row of a clamped texture extend beyond it.
    const double y0 = row == rows.first ? high.lo : static_cast<double>(row);
    const double y1 = row + 1 == rows.end ? high.hi : static_cast<double>(row + 1);
    const Range wide = width_between(triangle, y0, y1);
    if (wide.empty()) continue;
    const std::size_t cost = contour.most_cells(row, wide.lo, wide.hi) + 1;
    if (cost > looks) return false;
    looks -= cost;
    cells_.clear();
    contour.find_cells(row, wide.lo, wide.hi, high.lo, high.hi, cells_);
    for (const ContourCell& cell : cells_)
      if (!visit(cell)) return false;
  }
  return true;
}

bool ContourPlacer::comes_near(const TexturedTriangle& triangle, const AlphaContour& contour,
                               std::size_t& looks) {
  return !visit_cells(triangle, contour, looks, [](const ContourCell&) { return false; });
}

bool ContourPlacer::hides(glm::dvec2 p, glm::dvec2 q, const AlphaContour& contour,
                          std::size_t& looks) {
  TexturedTriangle line;
  line.texels = {p, q, q};
  const double length = glm::length(q - p);
  // Touching counts as crossing. The distance of a curve from its chord is at most the chord's
  // length.
  const auto passes_by = [&](const ContourPiece& piece) {
    const double h0 = cross(q - p, piece.from - p), h1 = cross(q - p, piece.to - p);
    return (h0 < 0.0) == (h1 < 0.0) &&
           std::min(std::abs(h0), std::abs(h1)) > glm::distance(piece.from, piece.to) * length;
  };
  const bool untouched = visit_cells(line, contour, looks, [&](const ContourCell& cell) {
    pieces_.clear();
    contour.find_pieces(cell, 1.0, pieces_);
    return std::all_of(pieces_.begin(), pieces_.end(), passes_by);
  });
  return untouched && !contour.keeps(0.5 * (p + q));
}

// Directs the sides so that two triangles that share one, with the same texture coordinates, agree
// bit for bit on two things: which parts of a piece belong to which triangle, and where the piece
// crosses the side.
void ContourPlacer::set_sides(const TexturedTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t i = k, j = (k + 1) % 3;
    const glm::dvec2 p = triangle.texels[i], q = triangle.texels[j];
    if (q.x < p.x || (q.x == p.x && q.y < p.y)) std::swap(i, j);
    Side& side = sides_[k];
    side.lo = triangle.texels[i];
    side.along = triangle.texels[j] - side.lo;
    side.lo_position = triangle.positions[i];
    side.along_position = triangle.positions[j] - side.lo_position;
    side.inside_is_left = side.height(triangle.texels[(k + 2) % 3]) < 0.0;
  }
  origin_ = triangle.texels[0];
  weights_ = glm::inverse(
      glm::dmat2(triangle.texels[1] - triangle.texels[0], triangle.texels[2] - triangle.texels[0]));
  corner_ = triangle.positions[0];
  edge1_ = triangle.positions[1] - corner_;
  edge2_ = triangle.positions[2] - corner_;
}

glm::vec3 ContourPlacer::placed(const End& end) const {
  if (end.side) return end.side->placed(end.at);
  const glm::dvec2 b = weights_ * (end.at - origin_);
  return glm::vec3(corner_ + b.x * edge1_ + b.y * edge2_);
}

std::optional<ContourPlacer::Line> ContourPlacer::clipped(const ContourPiece& piece) const {
  End from{piece.from}, to{piece.to};
  double t0 = 0.0, t1 = 1.0;
  for (const Side& side : sides_) {
    const double h0 = side.height(piece.from), h1 = side.height(piece.to);
    const bool in0 = (h0 < 0.0) == side.inside_is_left, in1 = (h1 < 0.0) == side.inside_is_left;
    if (!in0 && !in1) return std::nullopt;
    if (h0 == 0.0 && t0 == 0.0) from.side = &side;
    if (h1 == 0.0 && t1 == 1.0) to.side = &side;
    if (in0 == in1) continue;
    const double t = h0 / (h0 - h1);
    if (!in0 && t > t0) t0 = t, from.side = &side;
    if (!in1 && t < t1) t1 = t, to.side = &side;
  }
  if (!(t0 < t1)) return std::nullopt;
  const glm::dvec2 way = piece.to - piece.from;
  if (t0 > 0.0) from.at = piece.from + t0 * way;
  if (t1 < 1.0) to.at = piece.from + t1 * way;
  return Line{placed(from), placed(to)};
}

bool ContourPlacer::place(const TexturedTriangle& triangle, const AlphaContour& contour,
                          double tolerance, std::size_t most_lines, std::size_t& looks,
                          std::vector<Line>& lines) {
  set_sides(triangle);
  return visit_cells(triangle, contour, looks, [&](const ContourCell& cell) {
    pieces_.clear();
    contour.find_pieces(cell, tolerance, pieces_);
    for (const ContourPiece& piece : pieces_) {
      const std::optional<Line> line = clipped(piece);
      if (!line || line->from == line->to) continue;
      if (lines.size() == most_lines) return false;
      lines.push_back(*line);
    }
    return true;
  });
}

}  // namespace asos
