#include "renderer/samples/sampled_reflections.h"

#include "renderer/geometry/direction.h"
#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/reflections/horizon.h"
#include "renderer/reflections/mirror_surface.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/layers.h"
#include "renderer/shading/lobe_directions.h"
#include "renderer/shading/viewed_point.h"

#include <cmath>
#include <numbers>

namespace asos {
namespace {

static_assert(MirrorSettings::max_bounces < static_cast<int>(most_bounce_streams));

}  // namespace

ViewedRay ReflectedSample::viewed(const Hit& hit) const {
  return {ray,          hit, side,  &spacing, width, bounces, throughput,
          hides_lights, {},  false, passage,  {},    colours, passed};
}

// Replaces the direction of a smooth mirror by one sampled from the lobe. A lobe around a shading
// normal may contain directions below the surface, where nothing is visible. These are mirrored
// above the surface, so that no light is lost. Returns false if facets block the direction.
bool SampledReflections::turn_by_lobe(const Reflection& reflection, glm::dvec2 place,
                                      glm::dvec3& direction, glm::vec3& weight) {
  const SurfacePoint& point = reflection.point;
  const glm::vec3 to_viewer = -reflection.seen.ray.direction;
  const bool refracts = reflection.ratio > 0.0f;
  const glm::vec3 normal = refracts ? point.shading_normal : mirroring_normal(point, to_viewer);
  Lobe own = *reflection.lobe;
  if (normal != point.shading_normal)
    own.stretch.along -= glm::dot(own.stretch.along, normal) * normal;
  const LobeDirections lobe(own, point.spread.variance, normal, to_viewer);
  if (refracts) {
    const auto found = lobe.refracted(place, reflection.ratio);
    if (found && glm::dot(*found, point.geometric_normal) < 0.0f) direction = glm::dvec3(*found);
    return true;
  }
  const auto found = lobe.mirrored(place);
  if (!found) return false;
  direction = above_plane(glm::dvec3(found->unit), glm::dvec3(point.geometric_normal));
  weight *= found->weight;
  return true;
}

void SampledReflections::add(const Reflection& reflection, const PointSample& sample,
                             glm::vec3 weight, const Shader& shader) {
  ReflectedSample start;
  start.sample = sample;
  if (sample.part == LightPart::direct)
    start.sample.part = reflection.ratio > 0.0f ? LightPart::transmission : LightPart::reflection;
  start.weight = weight;
  start.side = reflection.seen.side > 0.0f ? reflection.seen.side : 1.0f;
  start.bounces = reflection.seen.bounces + 1;
  start.throughput = reflection.throughput();
  start.hides_lights = !reflection.shows_lights;
  start.passage = reflection.passage;
  if (reflection.one_width()) {
    add_ray(reflection, start, reflection.width.x, glm::vec3(1.0f), shader);
    return;
  }
  for (int c = 0; c < 3; ++c) {
    glm::vec3 colour(0.0f);
    colour[c] = 1.0f;
    add_ray(reflection, start, reflection.width[c], colour, shader);
  }
}

void SampledReflections::pass(const ViewedRay& seen, const SurfacePoint& point, const Rest& rest,
                              const PointSample& sample, glm::vec3 weight, const Shader& shader,
                              RenderStatistics& counts) {
  PassedLayers passed = seen.passed;
  passed.last = seen.hit.triangle;
  passed.left *= largest(rest.left);
  passed.distance = seen.hit.t;
  if (rest.clear)
    passed.count.pass_clear();
  else
    passed.count.add_layer();
  if (invisible(passed.left, passed.count.layers())) return;
  if (passed.count.full()) {
    ++counts.cut_stacks;
    return;
  }
  ReflectedSample next;
  next.sample = sample;
  next.weight = weight * rest.left;
  next.ray = seen.ray;
  next.ray.t_near = behind(seen.ray, point, seen.hit.t);
  next.spacing = seen.spacing ? *seen.spacing : shader.spacing();
  next.side = seen.side;
  next.width = seen.width;
  next.bounces = seen.bounces;
  next.throughput = seen.throughput * largest(rest.left);
  next.hides_lights = seen.hides_lights;
  next.passage = rest.passage;
  // A straight way is no bounce.
  next.passage.refractions = seen.passage.refractions;
  next.colours = seen.colours;
  next.passed = passed;
  passing_.push_back(next);
}

// Russian roulette (Arvo and Kirk 1990, "Particle transport and image synthesis"). Returns the
// probability by which to divide the weight of a ray that continues; 0: the ray ends.
float SampledReflections::chance(const Reflection& reflection, glm::vec3 weight) const {
  const float most = largest(weight);
  if (!(most < SampleTuning::least_followed)) return 1.0f;
  const float chance = most / SampleTuning::least_followed;
  // Decisions for rays from several surfaces of one sample are independent.
  const double ray = 2.0 * reflection.hit.triangle + (reflection.ratio > 0.0f ? 1.0 : 0.0);
  const double at =
      places_->in_lobe(SampleStream::roulette, reflection.seen.bounces).x + std::numbers::phi * ray;
  return at - std::floor(at) < static_cast<double>(chance) ? chance : 0.0f;
}

void SampledReflections::add_ray(const Reflection& reflection, const ReflectedSample& start,
                                 float width, glm::vec3 colours, const Shader& shader) {
  const float goes_on = chance(reflection, start.weight * reflection.reflected * colours);
  if (!(goes_on > 0.0f)) return;
  const ViewedRay& seen = reflection.seen;
  const PixelSpacing& spacing = seen.spacing ? *seen.spacing : shader.spacing();
  const IncidentPyray pyray = pyray_around(spacing, seen.ray, reflection.hit.t, start.side);
  MirrorSurface surface = mirror_surface(*world_, reflection.hit, reflection.point, pyray, true);
  if (reflection.ratio > 0.0f) surface = refracting(surface, static_cast<double>(reflection.ratio));
  const auto picture = mirrored(pyray, surface, {});
  ReflectedSample next = start;
  next.weight *= (reflection.lobe ? reflection.share : reflection.reflected) * colours / goes_on;
  next.width = seen.width + width;
  // Without a reflected pyramid the sample keeps its extent.
  next.spacing = picture ? spacing_of(*picture, start.side) : spacing;
  glm::dvec3 direction = mirrored_direction(surface, pyray.axis);
  if (reflection.lobe) {
    if (!turn_by_lobe(reflection, places_->in_lobe(SampleStream::reflections, seen.bounces),
                      direction, next.weight))
      return;
  } else if (width > 0.0f) {
    const MirrorLobe lobe =
        lobe_around(surface, direction, pyray.right, static_cast<double>(width));
    const glm::dvec3 right = lobe.width * lobe.right, down = lobe.width * lobe.down;
    const Horizon horizon{glm::dot(direction, surface.geometric),
                          glm::dot(right, surface.geometric), glm::dot(down, surface.geometric)};
    const glm::dvec2 at = places_->in_lobe(SampleStream::reflections, seen.bounces);
    if (!(horizon.at(at) > 0.0)) return;
    // Directions below the surface are dropped, and the rest represents all.
    next.weight /= static_cast<float>(horizon.share_above());
    direction = glm::normalize(direction + (at.x - 0.5) * right + (at.y - 0.5) * down);
  }
  next.ray = ray_leaving(surface, direction);
  next.mirror = plane_of(surface);
  pending_.push_back(next);
}

}  // namespace asos
