#include "renderer/comparison/block_facets.h"
#include "renderer/comparison/disk_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asos {

namespace {

// An object that intersects a cone.
struct ConeLayer {
  double nearness = 0.0;  // of the object's largest visible part
  double share = 0.0;     // fraction of the cone that the object covers
  glm::dvec3 radiance{0.0};
};

}  // namespace

/// Cone tracing (Amanatides 1984; CGF'98 section 2.7), for eye cones only: the cone's circle has
/// the area of a pixel. Each object covers a fraction of it, and the cone continues behind it,
/// reduced by that fraction. The fractions are exact here. The covered part of the cone is not
/// recorded, so two objects that each cover half cover three quarters, whether they lie behind each
/// other or side by side. Lights are sampled; mirrors show highlights and the sky.
BlockResult render_block_cone(const BlockJob& job) {
  BlockFacets seen(job, 1);
  ExactVisibility visibility;
  const double radius = seen.pixel() / std::sqrt(std::numbers::pi);
  const double all = seen.pixel() * seen.pixel();
  std::vector<ConeLayer> layers;
  return seen.run([&](int x, int y, bool& split) {
    const FrameRectangle square = seen.square(x, y, 2.0 * radius / seen.pixel());
    const glm::dvec2 centre = 0.5 * (square.lo + square.hi);
    layers.clear();
    for (const std::span<const Facet> object : seen.objects()) {
      ConeLayer layer;
      double largest = 0.0;
      for (const VisiblePart& part : visibility.find(object, square)) {
        if (part.facet == VisiblePart::background) continue;
        const double area = area_in_disk(part.polygon, centre, radius);
        if (!(area > 0.0)) continue;
        const Facet& facet = object[part.facet];
        layer.share += area / all;
        layer.radiance +=
            area / all *
            glm::dvec3(seen.radiance(&facet, part.centroid, std::sqrt(area) / seen.pixel()));
        if (area <= largest) continue;
        largest = area;
        layer.nearness = facet.q(part.centroid);
      }
      if (layer.share > 0.0) layers.push_back(layer);
    }
    std::stable_sort(layers.begin(), layers.end(), [](const ConeLayer& a, const ConeLayer& b) {
      return a.nearness > b.nearness;
    });
    glm::dvec3 sum(0.0);
    double left = 1.0;  // of the cone
    for (const ConeLayer& layer : layers) {
      sum += left * layer.radiance;
      left *= std::max(0.0, 1.0 - layer.share);
    }
    constexpr double nothing = 1e-9;
    split = layers.size() > 1 || (layers.size() == 1 && left > nothing);
    if (left > nothing) sum += left * glm::dvec3(seen.radiance(nullptr, centre, std::sqrt(left)));
    return glm::vec3(sum);
  });
}

}  // namespace asos
