#include "renderer/shadows/shadow_groups.h"

#include "renderer/pyray/tuning.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/shadow_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// Largest number of parts whose boxes are tested to save a ray.
constexpr std::size_t most_boxes = 256;

}  // namespace

double world_reach(const World& world) {
  if (world.bounds.empty()) return 1.0;
  return 2.0 * glm::length(glm::dvec3(world.bounds.hi) - glm::dvec3(world.bounds.lo)) +
         std::numeric_limits<float>::min();
}

SearchBounds own_part_ignored(const World& world, const PreparedLight& light) {
  SearchBounds bounds;
  bounds.first_shadowless_vertex = world.lines_and_points.first_vertex;
  bounds.shadowless_vertices = world.lines_and_points.vertex_count;
  if (light.own_part < 0) return bounds;
  const Part& part = world.parts[static_cast<std::size_t>(light.own_part)];
  bounds.first_ignored_vertex = part.first_vertex;
  bounds.ignored_vertices = part.vertex_count;
  return bounds;
}

ShadowGroups::ShadowGroups(const ShadowScene& scene)
    : scene_(scene), reach_(world_reach(scene.world)) {}

void ShadowGroups::reset(std::size_t lights) {
  lights_ = lights;
  used_ = 0;
}

void ShadowGroups::add(const Hit& hit, glm::vec3 position, glm::vec3 normal, const Patch& patch,
                       glm::vec3 lift) {
  // Find the group of the surface, or begin one.
  const std::uint32_t smooth_surface = scene_.features.smooth_surface(hit.triangle);
  std::size_t i = 0;
  while (i < used_ && groups_[i].smooth_surface != smooth_surface) ++i;
  if (i == used_) {
    if (groups_.size() == used_) groups_.emplace_back();
    Group& group = groups_[used_++];
    group.smooth_surface = smooth_surface;
    group.box = Box();
    group.plane = {glm::dvec3(normal), glm::dot(glm::dvec3(normal), glm::dvec3(position))};
    group.planar = glm::length(normal) > 0.5f;
    const glm::vec3 size = glm::abs(position);
    group.tolerance = 64.0 * std::numeric_limits<float>::epsilon() *
                      static_cast<double>(std::max({size.x, size.y, size.z}) +
                                          glm::length(patch.right) + glm::length(patch.down));
    group.answers.resize(lights_);
    for (Answer& answer : group.answers) answer.known = false;
    group.stood_upon.reset();
  }
  Group& group = groups_[i];
  // Grow the group's box by the patch, half as far again as the patch's first-order extent.
  const glm::vec3 around = 0.75f * (glm::abs(patch.right) + glm::abs(patch.down));
  if (!std::isfinite(around.x + around.y + around.z)) return;
  for (const glm::vec3 at : {position, position + lift}) {
    group.box.grow(at - around);
    group.box.grow(at + around);
  }
  group.planar = group.planar &&
                 std::abs(group.plane.height(glm::dvec3(position))) <= group.tolerance &&
                 glm::dot(glm::dvec3(normal), group.plane.normal) > 1.0 - 1e-9;
}

ShadowGroups::Group* ShadowGroups::group_of(const SurfacePoint& point, const Box& patch) {
  if (point.triangle == Hit::none) return nullptr;
  const std::uint32_t smooth_surface = scene_.features.smooth_surface(point.triangle);
  for (std::size_t i = 0; i < used_; ++i) {
    Group& group = groups_[i];
    if (group.smooth_surface != smooth_surface) continue;
    // Allow for patches smaller than the rounding error of their positions.
    const glm::vec3 slack = 2.0f * point.error;
    const bool inside = glm::all(glm::lessThanEqual(group.box.lo - slack, patch.lo)) &&
                        glm::all(glm::lessThanEqual(patch.hi, group.box.hi + slack));
    return inside ? &group : nullptr;
  }
  return nullptr;
}

// Returns a box around a light. For a distant light it is a box around the points where lines from
// `from` to the light leave the world.
Box ShadowGroups::light_box(const PreparedLight& light, const Box& from) const {
  Box box;
  if (light.traits().infinite) {
    const glm::vec3 away(reach_ * light.towards);
    const float wide = static_cast<float>(reach_ * light.radius);
    box.grow(from.lo + away - wide);
    box.grow(from.hi + away + wide);
    return box;
  }
  const double around = light.traits().flat ? 0.0 : light.radius;
  for (const double u : {-1.0, 1.0}) {
    for (const double v : {-1.0, 1.0}) {
      const glm::dvec3 p = light.position + u * light.half_u + v * light.half_v;
      box.grow(glm::vec3(p - around));
      box.grow(glm::vec3(p + around));
    }
  }
  return box;
}

// Returns whether the whole light is above a group's plane.
bool ShadowGroups::rises_above(const PreparedLight& light, const Group& group) const {
  const Box box = light_box(light, group.box);
  const glm::dvec3 n = group.plane.normal;
  const glm::dvec3 lowest(n.x > 0.0 ? box.lo.x : box.hi.x, n.y > 0.0 ? box.lo.y : box.hi.y,
                          n.z > 0.0 ? box.lo.z : box.hi.z);
  return group.plane.height(lowest) > group.tolerance;
}

void ShadowGroups::find(const PreparedLight& light, const SurfacePoint& point, Group& group,
                        Answer& answer, std::uint64_t& rays_cast) {
  using Passage = KnownVisibility::Passage;
  answer.known = true;
  answer.passage = Passage::open;
  // Search the shaft between the group and the light.
  Shaft shaft(group.box, light_box(light, group.box));
  if (group.planar) {
    const double above = static_cast<double>(clear_height(point)) + group.tolerance;
    shaft.keep_within({group.plane.normal, group.plane.offset + above});
  }
  search_shaft(scene_.features, shaft, own_part_ignored(scene_.world, light),
               SearchTuning::most_nodes, answer.search);
  if (!group.planar || !answer.search.complete || !answer.search.cut.empty()) return;
  if (stood_upon(group)) return;
  if (nothing_between(light, shaft)) {
    answer.passage = Passage::lit;
    return;
  }
  // The shadow on these points has no boundaries, so their visibility is the same and one ray
  // decides. Use a point of the light above the horizon.
  for (const double u : {0.5, 0.05, 0.95}) {
    for (const double v : {0.5, 0.05, 0.95}) {
      const LightSample at = sample_light(light, receiver_at(point), u, v);
      if (at.irradiance == glm::vec3(0.0f)) continue;
      const Ray ray = shadow_ray(point, at);
      Blocker blocker;
      scene_.rays.blockers(std::span(&ray, 1), std::span(&blocker, 1), light.own_part,
                           scene_.features.outlined());
      ++rays_cast;
      if (!blocker.see_through)
        answer.passage = blocker.hit.valid() ? Passage::shaded : Passage::lit;
      return;
    }
  }
}

// Returns whether an object stands on the group or passes through it. Its shadow has no boundary
// above the plane. The block may also contain both sides of the plane, since the eye sees through
// the backs of single-sided surfaces and through holes.
bool ShadowGroups::stood_upon(Group& group) const {
  if (!group.stood_upon) {
    const FeatureSet& features = scene_.features;
    // The edges of the group's own surface where it ends.
    const auto its_border = [&](const FeatureEdge& e) {
      const bool own =
          e.left_surface == group.smooth_surface || e.right_surface == group.smooth_surface;
      const bool of_several = e.kind == FeatureKind::open && e.right_surface != FeatureEdge::none;
      return own && e.kind != FeatureKind::intersection && !of_several;
    };
    group.stood_upon = any_edge(features, Shaft(group.box, group.box),
                                [&](const FeatureEdge& edge) { return !its_border(edge); });
  }
  return *group.stood_upon;
}

// Returns whether the boxes of the scene's parts prove that nothing is in between. With very many
// parts a ray costs less.
bool ShadowGroups::nothing_between(const PreparedLight& light, const Shaft& shaft) const {
  const std::vector<Part>& parts = scene_.world.parts;
  if (scene_.world.solid_parts() > most_boxes) return false;
  for (std::size_t i = 0; i < scene_.world.solid_parts(); ++i) {
    const bool own = light.own_part >= 0 && i == static_cast<std::size_t>(light.own_part);
    if (!own && !parts[i].shows_nothing() &&
        (parts[i].bounds.empty() || shaft.meets(parts[i].bounds)))
      return false;
  }
  return true;
}

KnownVisibility ShadowGroups::ask(const PreparedLight& light, std::uint32_t index,
                                  const SurfacePoint& point, const Box& patch,
                                  std::uint64_t& rays_cast) {
  Group* group = group_of(point, patch);
  if (!group) return {};
  // A group has no data for the other side of its surface, which diffuse transmission needs.
  const bool other_side = glm::dot(glm::dvec3(point.geometric_normal), group->plane.normal) < 0.0;
  if (group->planar && other_side) return {};
  // It has no data below its plane either, where a smooth surface may still receive light.
  if (group->planar && point.lift != glm::vec3(0.0f) && !rises_above(light, *group)) return {};
  Answer& answer = group->answers[index];
  if (!answer.known) find(light, point, *group, answer, rays_cast);
  const bool on_plane =
      std::abs(group->plane.height(glm::dvec3(point.position))) <= group->tolerance;
  if (group->planar && !on_plane) return {};
  return {answer.passage, &answer.search.cut};
}

}  // namespace asos
