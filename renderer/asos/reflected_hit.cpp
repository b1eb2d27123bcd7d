#include "renderer/asos/reflected_hit.h"

#include "renderer/reflections/mirror_surface.h"
#include "renderer/reflections/own_side.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Returns where the axis of a part of the frame starts.
glm::dvec3 start_of(const Frame& frame, const Bounds2& part) {
  if (!frame.parallel()) return frame.apex();
  const glm::vec2 middle = 0.5f * (part.lo + part.hi);
  return frame.world({static_cast<double>(middle.x), static_cast<double>(middle.y), 0.0});
}

// The pyray of the part of the parent's frame, in double precision because the reflection depends
// on it. Its distance is that of the plane through the sample's hit.
IncidentPyray incident_pyray(const Frame& frame, const Reflection& reflection,
                             const Bounds2& part) {
  const glm::dvec2 size(part.hi - part.lo);
  const glm::dvec2 middle = glm::dvec2(part.lo) + 0.5 * size;
  IncidentPyray pyray;
  pyray.perspective = !frame.parallel();
  pyray.right = size.x * frame.base_u();
  pyray.down = size.y * frame.base_v();
  pyray.axis = pyray.perspective
                   ? frame.base_corner() + middle.x * frame.base_u() + middle.y * frame.base_v()
                   : frame.direction();
  const glm::dvec3 n(reflection.point.geometric_normal);
  pyray.distance = glm::dot(n, glm::dvec3(reflection.point.position) - start_of(frame, part)) /
                   glm::dot(n, pyray.axis);
  return pyray;
}

// Returns the reflected hit as a pyramid (CGF'98 section 5).
std::optional<ReflectedHit> pyramid_sight(const EyeContext& eye, const Reflection& reflection,
                                          const Bounds2& part, float width) {
  IncidentPyray pyray = incident_pyray(*eye.frame, reflection, part);
  ReflectedHit sight;
  MirrorSurface& surface = sight.surface;
  surface = mirror_surface(eye.scene->world(), reflection.hit, reflection.point, pyray,
                           eye.settings->mirror.curved == CurvedMirror::approximate);
  if (reflection.ratio > 0.0f) surface = refracting(surface, static_cast<double>(reflection.ratio));
  // Start at the centre of the part, with the distance to the mirror's plane.
  const glm::dvec3 start = start_of(*eye.frame, part);
  pyray.distance = glm::dot(surface.geometric, surface.position - start) /
                   glm::dot(surface.geometric, pyray.axis);
  if (pyray.distance > 0.0 && std::isfinite(pyray.distance)) {
    surface.position = start + pyray.distance * pyray.axis;
  } else {
    // For an axis within the mirror's plane, use the sample's hit.
    pyray.distance = static_cast<double>(reflection.hit.t) / glm::length(pyray.axis);
  }
  const MirrorLobe lobe = lobe_around(surface, mirrored_direction(surface, pyray.axis), pyray.right,
                                      static_cast<double>(width));
  const auto reflected = mirrored(pyray, surface, lobe);
  if (!reflected) return std::nullopt;
  sight.pyray = *reflected;
  sight.exact = !surface.bent();
  if (width > 0.0f) sight.bundle = RayBundle::of(sight.pyray, surface.position);
  return sight;
}

// Returns the length of the ray in the centre of a bundle, or a length of twice the scene's size if
// it meets nothing.
double depth_of(const EyeContext& eye, const RayBundle& bundle, const MirrorSurface& surface,
                const VolumePath& passage, RenderStatistics& counts) {
  const RenderScene& scene = *eye.scene;
  const Culling faces = culling_of(*eye.settings);
  Ray ray = ray_leaving(surface, bundle.direction);
  Hit hit = scene.rays().closest(ray, faces);
  if (const auto plane = plane_of(surface))
    pass_mirror(*plane, scene.world(), scene.rays(), faces, {&ray, 1}, {&hit, 1});
  pass_own_side(passage, scene.world(), scene.rays(), faces, {&ray, 1}, {&hit, 1});
  ++counts.reflection_rays;
  if (hit.valid()) return static_cast<double>(hit.t);
  return 4.0 * radius_around_origin(scene.world().bounds);
}

// Returns the bundle of rays of a part of the viewer's frame.
RayBundle incident_bundle(const EyeContext& eye, const Reflection& reflection, const Bounds2& part,
                          bool whole) {
  const std::optional<RayBundle>& own = eye.viewer.bundle;
  if (!own) return RayBundle::of(*eye.frame, part);
  if (!own->blurred()) return own->part(part);
  if (whole) return *own;
  const double t = glm::dot(glm::dvec3(reflection.point.position) - own->origin, own->direction);
  return t > 0.0 ? own->blurred_part(part, t) : own->part(part);
}

std::optional<ReflectedHit> bundle_sight(const EyeContext& eye, const Reflection& reflection,
                                         const Bounds2& part, bool whole, float width,
                                         RenderStatistics& counts) {
  RayBundle bundle = incident_bundle(eye, reflection, part, whole);
  // Intersect the central ray with the surface's plane.
  const glm::dvec3 normal(reflection.point.geometric_normal);
  const auto meet = [&](glm::dvec3 n, glm::dvec3 position) {
    return glm::dot(n, position - bundle.origin) / glm::dot(n, bundle.direction);
  };
  double t = meet(normal, glm::dvec3(reflection.point.position));
  if (!(t > 0.0) || !std::isfinite(t)) {
    // For a ray within the plane, use the sample's hit.
    const glm::dvec3 off = glm::dvec3(reflection.point.position) - bundle.origin;
    t = glm::dot(off, bundle.direction);
    bundle.origin += off - t * bundle.direction;
  }
  IncidentPyray beam;
  beam.perspective = false;
  beam.axis = bundle.direction;
  beam.right = bundle.whole_section(t).right;
  beam.down = bundle.whole_section(t).down;
  beam.distance = t;

  ReflectedHit sight;
  MirrorSurface& surface = sight.surface;
  const bool bent = reflection.ratio > 0.0f || eye.viewer.passage.refractions > 0 ||
                    eye.settings->mirror.curved == CurvedMirror::approximate;
  surface = mirror_surface(eye.scene->world(), reflection.hit, reflection.point, beam, bent);
  if (reflection.ratio > 0.0f) surface = refracting(surface, static_cast<double>(reflection.ratio));
  const double exact = meet(surface.geometric, surface.position);
  surface.position =
      bundle.origin + (exact > 0.0 && std::isfinite(exact) ? exact : t) * bundle.direction;
  sight.bundle = mirrored(bundle, surface);
  const double depth = depth_of(eye, *sight.bundle, surface, reflection.passage, counts);
  sight.bundle->add_lobe(
      lobe_around(surface, sight.bundle->direction, beam.right, static_cast<double>(width)), depth);
  const auto pyray = pyramid_around(*sight.bundle, surface, depth);
  if (!pyray) return std::nullopt;
  sight.pyray = *pyray;
  return sight;
}

}  // namespace

std::optional<ReflectedHit> reflected_hit(const EyeContext& eye, const Reflection& reflection,
                                          const Bounds2& part, bool whole, float width,
                                          RenderStatistics& counts) {
  const bool by_bundle = reflection.ratio > 0.0f || eye.viewer.bundle;
  return by_bundle ? bundle_sight(eye, reflection, part, whole, width, counts)
                   : pyramid_sight(eye, reflection, part, width);
}

}  // namespace asos
