#include "ui/seen_parts.h"

#include <algorithm>
#include <cstddef>

namespace asos::ui {

namespace {

float x_at(const BorderEdge& side, float y) {
  const float share = (y - side.from.y) / (side.to.y - side.from.y);
  return glm::mix(side.from.x, side.to.x, std::clamp(share, 0.0f, 1.0f));
}

/// Splits an area at the heights of its corners into trapezoids: no two sides cross between these
/// heights. The area may have holes.
void add_trapezoids(const TracedSample& sample, std::vector<SeenPart>& parts) {
  const std::span<const BorderEdge> border = sample.border;
  std::vector<float> heights;
  for (const BorderEdge& side : border) heights.push_back(side.from.y);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<const BorderEdge*> crossed;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const float top = heights[i], bottom = heights[i + 1], middle = 0.5f * (top + bottom);
    crossed.clear();
    for (const BorderEdge& side : border)
      if ((side.from.y > middle) != (side.to.y > middle)) crossed.push_back(&side);
    std::sort(crossed.begin(), crossed.end(), [&](const BorderEdge* a, const BorderEdge* b) {
      return x_at(*a, middle) < x_at(*b, middle);
    });
    for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
      const BorderEdge& left = *crossed[k];
      const BorderEdge& right = *crossed[k + 1];
      parts.push_back(
          {{glm::vec2(x_at(left, top), top), glm::vec2(x_at(right, top), top),
            glm::vec2(x_at(right, bottom), bottom), glm::vec2(x_at(left, bottom), bottom)},
           sample.radiance,
           sample.triangle});
    }
  }
}

}  // namespace

double SeenPart::area() const {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a(corners[i]), b(corners[(i + 1) % corners.size()]);
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

std::vector<SeenPart> seen_parts(std::span<const TracedCell> cells) {
  std::vector<SeenPart> parts;
  for (const TracedCell& cell : cells) {
    for (const TracedSample& sample : cell.samples) {
      if (!sample.border.empty()) {
        add_trapezoids(sample, parts);
        continue;
      }
      const glm::vec2 lo = cell.corner, hi = cell.corner + cell.side;
      parts.push_back({{lo, glm::vec2(hi.x, lo.y), hi, glm::vec2(lo.x, hi.y)},
                       sample.radiance,
                       sample.triangle});
    }
  }
  return parts;
}

}  // namespace asos::ui
