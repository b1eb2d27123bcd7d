#include "renderer/asos/part_shape.h"

#include <cmath>

namespace asos {

// By Green's theorem, relative to the sample, so that nothing cancels.
PartShape part_shape(const LeafRegion& region, glm::vec2 at) {
  if (region.border.empty()) return {};
  double area = 0.0;
  glm::dvec2 first(0.0), square(0.0);
  double mixed = 0.0;
  for (const BorderEdge& side : region.border) {
    const glm::dvec2 p(side.from - at), q(side.to - at);
    const double cross = p.x * q.y - q.x * p.y;
    area += cross / 2.0;
    first += cross / 6.0 * (p + q);
    square += cross / 12.0 * (p * p + p * q + q * q);
    mixed += cross / 24.0 * (p.x * q.y + 2.0 * p.x * p.y + 2.0 * q.x * q.y + q.x * p.y);
  }
  const glm::dvec2 mean = first / area;
  const glm::dvec2 variance = square / area - mean * mean;
  const double covariance = mixed / area - mean.x * mean.y;
  // A parallelogram with these edges e and f has the covariance (e e^T + f f^T) / 12.
  const double side = std::sqrt(std::abs(area));
  const double along = std::sqrt(12.0 * variance.x);
  const double lean = 12.0 * covariance / along;
  const double across = std::sqrt(12.0 * variance.y - lean * lean);
  const PartShape shape{glm::vec2(mean / side), glm::vec2(along / side, lean / side),
                        glm::vec2(0.0, across / side)};
  const bool sound = std::isfinite(mean.x + mean.y) && along > 0.0 && across > 0.0;
  return sound ? shape : PartShape{};
}

}  // namespace asos
