#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/ray.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/world/world.h"
#include "tests/support/polygon.h"
#include "tests/support/triangle_crossing.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace asos::test {

/// Flat convex polygons, one part each, for tests of the engine without the importer.
class PolygonScene {
 public:
  PolygonScene() { world.materials.resize(1); }

  /// Adds a convex polygon as a fan of triangles; returns its part.
  std::uint32_t add(const std::vector<glm::vec3>& corners) {
    Part part;
    part.first_triangle = static_cast<std::uint32_t>(world.triangles.size());
    part.first_vertex = static_cast<std::uint32_t>(world.positions.size());
    part.vertex_count = static_cast<std::uint32_t>(corners.size());
    part.triangle_count = part.vertex_count - 2;
    const auto id = static_cast<std::uint32_t>(world.parts.size());
    const glm::vec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (const glm::vec3& p : corners) {
      world.positions.push_back(p);
      world.normals.push_back(normal);
      world.bounds.grow(p);
    }
    for (std::uint32_t i = 1; i + 1 < part.vertex_count; ++i) {
      world.triangles.push_back(part.first_vertex + glm::uvec3(0, i, i + 1));
      world.triangle_part.push_back(id);
    }
    world.parts.push_back(part);
    return id;
  }

  World world;
};

/// A Caster for one frame that tests every triangle in double precision, and sums the weight that
/// each part covers.
class BruteForceCaster : public Caster {
 public:
  BruteForceCaster(const World& world, const FeatureSet& features, const Frame& frame)
      : coverage(world.parts.size()), world_(world), features_(features), frame_(frame) {}

  SampleId probe(std::span<const glm::vec2> points) override {
    const std::size_t first = samples_.size();
    for (const glm::vec2& p : points) samples_.push_back(look(p.x, p.y));
    return static_cast<SampleId>(first);
  }

  [[nodiscard]] OccluderPlane cover(SampleId id) const override {
    const Sample& s = samples_[id];
    if (s.triangle == Hit::none) return OccluderPlane::none();
    const glm::uvec3 i = world_.triangles[s.triangle];
    const glm::dvec3 a(world_.positions[i.x]);
    return OccluderPlane::plane(
        frame_, s.point,
        glm::cross(glm::dvec3(world_.positions[i.y]) - a, glm::dvec3(world_.positions[i.z]) - a));
  }

  [[nodiscard]] std::uint32_t surface(SampleId id) const override {
    const std::uint32_t t = samples_[id].triangle;
    return t == Hit::none ? Hit::none : features_.smooth_surface(t);
  }

  void take(std::span<const PyrayLeaf> leaves) override {
    for (const PyrayLeaf& leaf : leaves) {
      total += leaf.weight;
      const std::uint32_t t = samples_[leaf.sample].triangle;
      if (t != Hit::none) coverage[world_.triangle_part[t]] += leaf.weight;
    }
  }

  [[nodiscard]] int probes() const { return static_cast<int>(samples_.size()); }

  std::vector<double> coverage;  ///< of each part, 0 to 1
  double total = 0.0;            ///< coverage of all leaves

 private:
  struct Sample {
    std::uint32_t triangle = Hit::none;
    glm::dvec3 point{0.0};
  };

  [[nodiscard]] Sample look(float u, float v) const {
    const double near = frame_.parallel() ? 0.0 : 1.0;
    const glm::dvec3 origin = frame_.parallel() ? frame_.world({u, v, 0.0}) : frame_.apex();
    const glm::dvec3 d = frame_.world({u, v, near ? 1.0 : -1.0}) - origin;
    Sample best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < world_.triangles.size(); ++t) {
      const auto met = crossing(world_, t, origin, d);
      if (!met || !(met->inside() >= 0.0 && met->t > 0.0 && met->t < nearest)) continue;
      nearest = met->t;
      best = {t, origin + met->t * d};
    }
    return best;
  }

  const World& world_;
  const FeatureSet& features_;
  const Frame& frame_;
  std::vector<Sample> samples_;
};

/// Looks down -Z from the origin at the square 0 <= x, y <= 1 at distance 1, so that a point (x, y,
/// 1) * d in (x, -y, -z) is at (u, v) = (x, y). The world point at (u, v) and depth d:
inline glm::vec3 at_depth(double u, double v, double depth) {
  return glm::vec3(glm::dvec3(u, -v, -1.0) * depth);
}
inline Frame unit_frame() {
  return Frame::pyramid({0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0});
}

}  // namespace asos::test
