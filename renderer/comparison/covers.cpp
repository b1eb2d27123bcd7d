#include "renderer/comparison/block_facets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asos {

namespace {

// Returns the point of a convex polygon that is nearest to `p`, which lies outside or on the
// boundary.
glm::dvec2 nearest_on_rim(const ConvexPolygon& polygon, glm::dvec2 p) {
  glm::dvec2 nearest = polygon.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
    const double length2 = glm::dot(d, d);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 at = a + t * d, away = at - p;
    if (glm::dot(away, away) >= least) continue;
    least = glm::dot(away, away);
    nearest = at;
  }
  return nearest;
}

bool contains(const ConvexPolygon& polygon, glm::dvec2 p) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    left |= side > 0.0;
    right |= side < 0.0;
  }
  return !(left && right);
}

// An object whose cover contains a ray.
struct CoverLayer {
  const Facet* facet = nullptr;
  glm::dvec2 at{0.0};   // the shading point
  double weight = 0.0;  // of the object, 0 to 1
};

// Returns the object's layer. Its weight depends on the distance of the ray from the object's
// nearest edge: 1 at half a pixel or more inside the object, 0 at half a pixel or more outside.
CoverLayer layer_of(std::span<const Facet> object, std::span<const VisiblePart> parts,
                    glm::dvec2 centre, double pixel) {
  CoverLayer layer;
  double outside = std::numeric_limits<double>::infinity(), inside = outside;
  bool hit = false;
  for (const VisiblePart& part : parts) {
    const bool around = contains(part.polygon, centre);
    const glm::dvec2 rim = nearest_on_rim(part.polygon, centre);
    const double distance = around ? 0.0 : glm::distance(rim, centre);
    if (part.facet == VisiblePart::background) {
      inside = std::min(inside, distance);
      continue;
    }
    hit |= around;
    if (distance >= outside) continue;
    outside = distance;
    layer.facet = &object[part.facet];
    layer.at = around ? centre : rim;
  }
  if (!layer.facet) return layer;
  const double signed_pixels = (hit ? inside : -outside) / pixel;
  layer.weight = std::clamp(0.5 + signed_pixels, 0.0, 1.0);
  return layer;
}

}  // namespace

/// Covers (Thomas, Netravali and Fox 1989; CGF'98 section 2.8), for eye rays only. Objects have an
/// inner and an outer cover, half a pixel from their edges. A ray inside a cover is split: its
/// weight on the object depends on the distance of the nearest edge alone, and the rest continues
/// behind. Objects thinner than a pixel get too much weight. As with cones, the covered part of a
/// pixel is not recorded. Lights are sampled; mirrors show highlights and the sky.
BlockResult render_block_covers(const BlockJob& job) {
  BlockFacets seen(job);
  ExactVisibility visibility;
  std::vector<CoverLayer> layers;
  return seen.run([&](int x, int y, bool& split) {
    const FrameRectangle square = seen.square(x, y);
    const glm::dvec2 centre = 0.5 * (square.lo + square.hi);
    layers.clear();
    for (const std::span<const Facet> object : seen.objects()) {
      const CoverLayer layer =
          layer_of(object, visibility.find(object, square), centre, seen.pixel());
      if (layer.weight > 0.0) layers.push_back(layer);
    }
    std::stable_sort(layers.begin(), layers.end(), [](const CoverLayer& a, const CoverLayer& b) {
      return a.facet->q(a.at) > b.facet->q(b.at);
    });
    glm::dvec3 sum(0.0);
    double left = 1.0;
    for (const CoverLayer& layer : layers) {
      if (!(left > 0.0)) break;
      sum += left * layer.weight * glm::dvec3(seen.radiance(layer.facet, layer.at, 1.0));
      left *= 1.0 - layer.weight;
      split |= layer.weight < 1.0;
    }
    if (left > 0.0) sum += left * glm::dvec3(seen.radiance(nullptr, centre, 1.0));
    return glm::vec3(sum);
  });
}

}  // namespace asos
