#pragma once

#include "renderer/published/published_subdivision.h"
#include "renderer/pyray/tracer.h"
#include "tests/support/polygon.h"
#include "tests/support/polygon_scene.h"

#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <vector>

// Subdivides one pyray over a scene of polygons.

namespace asos::test {

/// A pixel of an orthographic view: (u, v) across it is the world's (x, -y). The frame includes
/// half a pixel around it, so that edges are known as far as its cone reaches.
inline Pyray parallel_pixel() {
  return {Frame::prism({-0.5, 0.5, 0}, {0, 0, -1}, {2, 0, 0}, {0, -2, 0}), {0.25f, 0.25f, 0.5f}};
}

/// The whole square of the unit frame.
inline Pyray unit_pyray() {
  return {unit_frame()};
}

struct Answer {
  std::vector<double> coverage;  ///< of each part, as a fraction of the pyray
  double total = 0.0;            ///< coverage of all leaves
  int probes = 0;
  SubdivisionOutcome outcome;
};

/// `features` are those of the world.
inline Answer subdivide(const World& world, const FeatureSet& features,
                        const SubdivisionRules& rules, const Pyray& pyray = unit_pyray(),
                        TracedPyray* traced = nullptr) {
  BruteForceCaster caster(world, features, pyray.frame);
  Tracer tracer;
  Answer answer;
  answer.outcome = tracer.trace(features, pyray, rules, caster, traced).outcome;
  answer.coverage = caster.coverage;
  answer.total = caster.total;
  answer.probes = caster.probes();
  return answer;
}

inline Answer subdivide(const World& world, const SubdivisionRules& rules,
                        const Pyray& pyray = unit_pyray(), TracedPyray* traced = nullptr) {
  return subdivide(world, FeatureSet(world), rules, pyray, traced);
}

/// A variant that exists until the program ends.
inline const SubdivisionVariant* variant_of(Detection detection, StoppingRule rule, LeafKind leaf) {
  static std::map<std::tuple<Detection, StoppingRule, LeafKind>, PublishedSubdivision> made;
  return &made.try_emplace({detection, rule, leaf}, detection, rule, leaf).first->second;
}

inline SubdivisionRules rules_of(int max_level, double eps = 0.0, bool exact = true,
                                 StoppingRule rule = StoppingRule::unresolved,
                                 Detection detection = Detection::square) {
  SubdivisionRules rules{.error_budget = {.max_level = max_level, .eps = eps}};
  if (!exact || rule != StoppingRule::unresolved || detection != Detection::square)
    rules.variant = variant_of(detection, rule, exact ? LeafKind::exact : LeafKind::point);
  return rules;
}

/// Point leaves and the published rule, with the given detection.
inline SubdivisionRules published_rules(int max_level, double eps,
                                        Detection detection = Detection::cone) {
  return rules_of(max_level, eps, false, StoppingRule::published, detection);
}

/// Adds a convex polygon in the unit frame's (u, v) at a depth; returns its part.
inline std::uint32_t add_polygon(PolygonScene& scene, const Polygon& corners, double depth) {
  std::vector<glm::vec3> points;
  for (const glm::dvec2& c : corners) points.push_back(at_depth(c.x, c.y, depth));
  return scene.add(points);
}

/// Adds a polygon in the (u, v) of the orthographic pixel.
inline std::uint32_t add_parallel_polygon(PolygonScene& scene, const Polygon& corners,
                                          double depth = 3.0) {
  std::vector<glm::vec3> points;
  for (const glm::dvec2& c : corners) points.emplace_back(c.x, -c.y, -depth);
  return scene.add(points);
}

/// The half-plane to the left of a line through p (with v upwards), large enough for one pixel.
inline Polygon half_plane(glm::dvec2 p, glm::dvec2 direction) {
  const glm::dvec2 d = 4.0 * direction;
  const glm::dvec2 n(-d.y, d.x);
  return {p - d, p + d, p + d + n, p - d + n};
}
inline Polygon half_plane(glm::dvec2 p, double angle) {
  return half_plane(p, glm::dvec2(std::cos(angle), std::sin(angle)));
}

}  // namespace asos::test
