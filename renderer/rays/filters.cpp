#include "renderer/rays/filters.h"

#include "renderer/rays/back_face.h"

#include <algorithm>

namespace asos::tracing {
namespace {

const Context& context_of(const RTCFilterFunctionNArguments& args) {
  return *reinterpret_cast<const Context*>(args.context);
}

/// One candidate of a call, which has up to 16 rays.
struct Candidate {
  const RTCFilterFunctionNArguments& args;
  const Group& group;
  unsigned i;

  [[nodiscard]] std::uint32_t triangle() const {
    return context_of(args).geometries.hit(args, i).triangle;
  }
  [[nodiscard]] const World& world() const { return context_of(args).world(); }
  [[nodiscard]] float opacity() const {
    return group.open.alpha(world(), triangle(), RTCHitN_u(args.hit, args.N, i),
                            RTCHitN_v(args.hit, args.N, i));
  }
  [[nodiscard]] Hit hit() const { return context_of(args).geometries.hit(args, i); }
  [[nodiscard]] glm::vec3 direction() const {
    return context_of(args).geometries.direction(args, i);
  }
  [[nodiscard]] bool hole() const {
    return opacity() < world().material_of(triangle()).alpha_cutoff;
  }
  [[nodiscard]] bool ignored(std::int32_t part) const {
    return group.owned && part >= 0 &&
           world().triangle_part[triangle()] == static_cast<std::uint32_t>(part);
  }
  // Embree passes packets as a whole or ray by ray; the id is the ray's lane.
  [[nodiscard]] std::size_t lane() const { return RTCRayN_id(args.ray, args.N, i); }
  [[nodiscard]] float t() const { return RTCRayN_tfar(args.ray, args.N, i); }
};

/// Calls `keeps` for each candidate and drops the candidate if it returns false.
template <typename Keeps>
void filter(const RTCFilterFunctionNArguments& args, Keeps keeps) {
  const Group& group = *static_cast<const Group*>(args.geometryUserPtr);
  const std::int32_t ignored_part = context_of(args).ignored_part;
  const bool passes_all = group.shadowless && context_of(args).of_shadows;
  for (unsigned i = 0; i < args.N; ++i) {
    if (args.valid[i] != -1) continue;
    const Candidate candidate{args, group, i};
    if (!candidate.hit().valid()) {
      args.valid[i] = 0;  // hidden
      continue;
    }
    if (passes_all || candidate.ignored(ignored_part) || !keeps(candidate)) args.valid[i] = 0;
  }
}

/// Attenuates a ray at a blended surface. Returns the largest remaining fraction of its light over
/// the colours.
float pass(const Candidate& candidate, Lanes& lanes) {
  glm::vec3& left = lanes.transmittance[candidate.lane()];
  if (!candidate.group.open.passage) return most(left *= 1.0f - candidate.opacity());
  const glm::vec3 direction = candidate.direction();
  const StraightTransmission through =
      candidate.group.open.passage(candidate.world(), candidate.hit(), direction);
  if (lanes.volumes && through.extinction != glm::vec3(0.0f)) {
    const glm::vec3 extinction = through.enters ? through.extinction : -through.extinction;
    const float way = candidate.t() / candidate.group.scale * glm::length(direction);
    lanes.depth[candidate.lane()] -= way * extinction;
    lanes.entered[candidate.lane()] += extinction;
  }
  return most(left *= through.share);
}

}  // namespace

Hit Geometries::hit(const RTCFilterFunctionNArguments& args, unsigned i) const {
  return hit(RTCHitN_geomID(args.hit, args.N, i), RTCHitN_primID(args.hit, args.N, i),
             RTCHitN_instID(args.hit, args.N, i, 0), 0.0f, RTCHitN_u(args.hit, args.N, i),
             RTCHitN_v(args.hit, args.N, i));
}

glm::vec3 Geometries::direction(const RTCFilterFunctionNArguments& args, unsigned i) const {
  const glm::vec3 of_ray(RTCRayN_dir_x(args.ray, args.N, i), RTCRayN_dir_y(args.ray, args.N, i),
                         RTCRayN_dir_z(args.ray, args.N, i));
  return direction(of_ray, RTCHitN_instID(args.hit, args.N, i, 0));
}

bool Sides::culled(const Hit& hit, glm::vec3 direction) const {
  return single_sided[world->triangle_part[hit.triangle]] != 0 &&
         meets_back(*world, hit, direction);
}

void closest_filter(const RTCFilterFunctionNArguments* args) {
  Lanes* lanes = context_of(*args).lanes;
  const std::span outlined = context_of(*args).outlined;
  filter(*args, [lanes, outlined](const Candidate& candidate) {
    const SurfaceKind kind = candidate.group.kind;
    if (kind == SurfaceKind::opaque) return true;
    const bool known =
        kind == SurfaceKind::masked && !outlined.empty() && outlined[candidate.triangle()] != 0;
    if (lanes && !known) {
      float& touched = lanes->touched[candidate.lane()];
      touched = std::min(touched, candidate.t());
      float& masked = lanes->masked[candidate.lane()];
      if (kind == SurfaceKind::masked) masked = std::min(masked, candidate.t());
    }
    if (kind == SurfaceKind::masked) return !candidate.hole();
    if (!lanes) return true;
    pass(candidate, *lanes);
    return false;
  });
}

void shadow_filter(const RTCFilterFunctionNArguments* args) {
  Lanes& lanes = *context_of(*args).lanes;
  filter(*args, [&lanes](const Candidate& candidate) {
    switch (candidate.group.kind) {
      case SurfaceKind::opaque:
        return true;
      case SurfaceKind::masked:
        return !candidate.hole();
      case SurfaceKind::blended:
        return pass(candidate, lanes) <= opaque_enough;
    }
    return true;
  });
}

void hiding_filter(const RTCFilterFunctionNArguments* args) {
  const Geometries& geometries = context_of(*args).geometries;
  for (unsigned i = 0; i < args->N; ++i)
    if (args->valid[i] == -1 && !geometries.hit(*args, i).valid()) args->valid[i] = 0;
}

void back_filter(const RTCFilterFunctionNArguments* args) {
  const Context& context = context_of(*args);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const Hit hit = context.geometries.hit(*args, i);
    if (!hit.valid() || context.sides.culled(hit, context.geometries.direction(*args, i)))
      args->valid[i] = 0;
  }
}

}  // namespace asos::tracing
