#include "renderer/comparison/block_facets.h"

#include <cmath>

namespace asos {

/// Beam tracing (CGF'98 section 2.6), for eye beams only: a pixel is the sum over its exactly
/// visible polygons of area times radiance at the centroid. MAX, EPS and the number of samples have
/// no effect. The areas are exact for opaque surfaces only: triangles of a cut-out or transparent
/// surface hide everything behind them, except for layers that the shader finds along the
/// centroid's ray. For small scenes: see check_method.
BlockResult render_block_beam(const BlockJob& job) {
  BlockFacets seen(job);
  ExactVisibility visibility;
  return seen.run([&](int x, int y, bool& split) {
    const auto parts = visibility.find(seen.facets(), seen.square(x, y));
    split = parts.size() > 1;
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const VisiblePart& part : parts) {
      const Facet* facet =
          part.facet == VisiblePart::background ? nullptr : &seen.facets()[part.facet];
      sum += part.area *
             glm::dvec3(seen.radiance(facet, part.centroid, std::sqrt(part.area) / seen.pixel()));
      area += part.area;
    }
    return area > 0.0 ? glm::vec3(sum / area) : glm::vec3(0.0f);
  });
}

}  // namespace asos
