#include "renderer/lights/emitter_shapes.h"
#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace asos {
namespace {

using Outline = std::vector<glm::dvec3>;

// Largest difference between the outlines' area and the triangles', as a fraction. Largest distance
// of a corner from the line between its neighbours, relative to the line's length. Largest
// deviation from a right angle, as a cosine.
constexpr double area_tolerance = 5e-3;
constexpr double straightness = 1e-5;
constexpr double squareness = 1e-4;

struct DirectedEdge {
  std::uint32_t from, to;
  glm::dvec3 begin, end;
};

/// Returns the region's directed edges without a triangle on the other side.
std::vector<DirectedEdge> border_of(std::span<const EmitterTriangle> triangles,
                                    const Piece& region) {
  std::vector<DirectedEdge> edges;
  for (const std::uint32_t i : region) {
    const EmitterTriangle& t = triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (t.vertex[k] != t.vertex[next])
        edges.push_back({t.vertex[k], t.vertex[next], t.corner[k], t.corner[next]});
    }
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> surplus;
  for (const DirectedEdge& e : edges) ++surplus[{e.from, e.to}];
  std::erase_if(edges, [&](const DirectedEdge& e) { return surplus.contains({e.to, e.from}); });
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::pair{a.from, a.to} < std::pair{b.from, b.to};
  });
  return edges;
}

/// Returns the clockwise angle, in (0, 2 pi], from `from` to `to`, seen against the normal.
double clockwise_angle(glm::dvec3 from, glm::dvec3 to, glm::dvec3 normal) {
  const double angle = -std::atan2(glm::dot(normal, glm::cross(from, to)), glm::dot(from, to));
  return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

/// Connects the border's edges to outlines. Where several edges leave a corner, the outline
/// continues along the same inside, so that regions that touch at a corner have their own outlines.
std::vector<Outline> outlines_of(const std::vector<DirectedEdge>& edges, glm::dvec3 normal) {
  std::vector<Outline> outlines;
  std::vector<bool> used(edges.size(), false);
  const auto next_of = [&](const DirectedEdge& edge) {
    auto at = std::lower_bound(
        edges.begin(), edges.end(), edge.to,
        [](const DirectedEdge& e, std::uint32_t vertex) { return e.from < vertex; });
    std::size_t best = edges.size();
    double least = std::numeric_limits<double>::infinity();
    for (; at != edges.end() && at->from == edge.to; ++at) {
      const auto index = static_cast<std::size_t>(at - edges.begin());
      if (used[index]) continue;
      const double angle = clockwise_angle(edge.begin - edge.end, at->end - at->begin, normal);
      if (angle < least) least = angle, best = index;
    }
    return best;
  };
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    Outline& outline = outlines.emplace_back();
    for (std::size_t at = first; at < edges.size(); at = next_of(edges[at])) {
      used[at] = true;
      outline.push_back(edges[at].begin);
    }
  }
  return outlines;
}

/// Removes corners that lie on the line between their neighbours.
Outline without_straight_corners(const Outline& outline) {
  Outline kept = outline;
  for (bool changed = true; changed && kept.size() > 3;) {
    changed = false;
    for (std::size_t i = 0; i < kept.size() && kept.size() > 3;) {
      const glm::dvec3 before = kept[(i + kept.size() - 1) % kept.size()];
      const glm::dvec3 along = kept[(i + 1) % kept.size()] - before;
      const double length = glm::length(along);
      const double off = glm::length(glm::cross(kept[i] - before, along));
      if (off <= straightness * length * length) {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
      } else {
        ++i;
      }
    }
  }
  return kept;
}

glm::dvec3 area_vector(const Outline& outline) {
  glm::dvec3 twice(0.0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    twice += glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return 0.5 * twice;
}

/// Replaces a regular outline with many corners by a disk with the same area.
bool round_off(Light& light, double area) {
  constexpr double roundness = 0.01;
  const double radius = std::sqrt(area / std::numbers::pi);
  if (light.outlines.size() != 1) return false;
  for (const glm::dvec3& corner : light.outlines[0]) {
    if (std::abs(glm::distance(corner, light.position) - radius) > roundness * radius) return false;
  }
  light.type = Light::Type::disk;
  light.radius = radius;
  light.outlines.clear();
  return true;
}

/// Replaces a polygon with four right angles by a rectangle.
void simplify(Light& light) {
  if (light.outlines.size() != 1 || light.outlines[0].size() != 4) return;
  const Outline& c = light.outlines[0];
  const glm::dvec3 u = 0.25 * (c[1] - c[0] + c[2] - c[3]);
  const glm::dvec3 v = 0.25 * (c[2] - c[1] + c[3] - c[0]);
  const glm::dvec3 skew = 0.25 * (c[0] - c[1] + c[2] - c[3]);
  const double least = std::min(glm::length(u), glm::length(v));
  if (!(glm::length(skew) <= squareness * least)) return;
  if (!(std::abs(glm::dot(u, v)) <= squareness * glm::length(u) * glm::length(v))) return;
  light.type = Light::Type::rectangle;
  light.position = 0.25 * (c[0] + c[1] + c[2] + c[3]);
  light.half_u = u;
  light.half_v = v - glm::dot(v, u) / glm::dot(u, u) * u;
  light.outlines.clear();
}

}  // namespace

std::optional<Light> polygon_light(std::span<const EmitterTriangle> triangles, const Piece& region,
                                   bool two_sided) {
  const Moments moments = Moments::of(triangles, region);
  Light light;
  light.type = Light::Type::polygon;
  light.position = moments.centre;
  light.direction = glm::normalize(moments.area_vector);
  light.two_sided = two_sided;
  glm::dvec3 enclosed(0.0);
  std::size_t corners = 0;
  for (const Outline& outline : outlines_of(border_of(triangles, region), light.direction)) {
    const Outline kept = without_straight_corners(outline);
    enclosed += area_vector(kept);
    corners += kept.size();
    light.outlines.push_back(kept);
  }
  const double area = glm::dot(enclosed, light.direction);
  if (!(std::abs(area - moments.area) <= area_tolerance * moments.area)) return std::nullopt;
  if (corners > most_corners && !round_off(light, area)) return std::nullopt;
  simplify(light);
  // Outlines that cross or cover each other enclose less than the sum of their areas.
  const double shining = prepare_light(light).area;
  if (!(std::abs(shining - moments.area) <= area_tolerance * moments.area)) return std::nullopt;
  const glm::dvec3 radiance = moments.power / shining;
  light.intensity = static_cast<float>(std::max({radiance.x, radiance.y, radiance.z}));
  if (!(light.intensity > 0.0f) || !std::isfinite(light.intensity)) return std::nullopt;
  light.color = glm::vec3(radiance / static_cast<double>(light.intensity));
  return light;
}

}  // namespace asos
