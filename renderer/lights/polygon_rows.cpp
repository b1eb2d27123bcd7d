#include "renderer/lights/polygon_rows.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

struct Side {
  glm::dvec2 low, high;

  [[nodiscard]] double x_at(double y) const {
    if (y == high.y) return high.x;
    return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
  }
};

std::vector<Side> sides_of(std::span<const std::vector<glm::dvec2>> outlines) {
  std::vector<Side> sides;
  for (const std::vector<glm::dvec2>& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 a = outline[i];
      const glm::dvec2 b = outline[i + 1 < outline.size() ? i + 1 : 0];
      if (a.y != b.y) sides.push_back(a.y < b.y ? Side{a, b} : Side{b, a});
    }
  }
  return sides;
}

/// x at the bottom and the top of a row.
struct Crossing {
  double x0, x1;
};

}  // namespace

PolygonRows PolygonRows::of(std::span<const std::vector<glm::dvec2>> outlines) {
  PolygonRows result;
  const std::vector<Side> sides = sides_of(outlines);
  std::vector<double> heights;
  for (const Side& side : sides) heights.insert(heights.end(), {side.low.y, side.high.y});
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    Row row;
    row.y0 = heights[i];
    row.y1 = heights[i + 1];
    crossings.clear();
    for (const Side& side : sides) {
      if (side.low.y <= row.y0 && side.high.y >= row.y1)
        crossings.push_back({side.x_at(row.y0), side.x_at(row.y1)});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x0 + a.x1 < b.x0 + b.x1; });
    row.first = static_cast<std::uint32_t>(result.trapezoids.size());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      result.trapezoids.push_back(
          {crossings[k].x0, crossings[k].x1, crossings[k + 1].x0, crossings[k + 1].x1});
      row.width0 += crossings[k + 1].x0 - crossings[k].x0;
      row.width1 += crossings[k + 1].x1 - crossings[k].x1;
      ++row.count;
    }
    row.area_before = result.area;
    const double area = 0.5 * (row.width0 + row.width1) * (row.y1 - row.y0);
    if (!(area > 0.0)) {
      result.trapezoids.resize(row.first);
      continue;
    }
    result.area += area;
    result.rows.push_back(row);
  }
  return result;
}

glm::dvec2 PolygonRows::point(double u, double v) const {
  const double wanted = v * area;
  auto above = std::upper_bound(rows.begin() + 1, rows.end(), wanted,
                                [](double w, const Row& row) { return w < row.area_before; });
  const Row& row = *(above - 1);

  // The area up to the fraction t of the row is height (width0 t + (width1 - width0) t^2 / 2).
  const double strip = std::max(0.0, wanted - row.area_before) / (row.y1 - row.y0);
  const double widening = row.width1 - row.width0;
  const double root = std::sqrt(std::max(0.0, row.width0 * row.width0 + 2.0 * widening * strip));
  const double t = strip > 0.0 ? std::min(1.0, 2.0 * strip / (row.width0 + root)) : 0.0;

  double x = u * (row.width0 + widening * t);
  const double y = row.y0 + (row.y1 - row.y0) * t;
  double left = 0.0;
  for (std::uint32_t k = 0; k < row.count; ++k) {
    const Trapezoid& piece = trapezoids[row.first + k];
    left = piece.left0 + (piece.left1 - piece.left0) * t;
    const double width = piece.right0 + (piece.right1 - piece.right0) * t - left;
    if (x <= width || k + 1 == row.count) {
      x = std::min(x, width);
      break;
    }
    x -= width;
  }
  return {left + x, y};
}

}  // namespace asos
