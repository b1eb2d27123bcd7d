#include "renderer/rays/face_geometry.h"

#include "renderer/geometry/face_crossings.h"
#include "renderer/task_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asos::tracing {
namespace {

/// Returns a face whose points move linearly from `a` to `b`, at a fraction of the way.
ShapeFace between(const ShapeFace& a, const ShapeFace& b, double way) {
  ShapeFace face = a;
  face.bottom = glm::mix(a.bottom, b.bottom, way);
  face.top = glm::mix(a.top, b.top, way);
  face.world_from_unit = (1.0 - way) * a.world_from_unit + way * b.world_from_unit;
  face.origin = glm::mix(a.origin, b.origin, way);
  face.unit_from_world = glm::inverse(face.world_from_unit);
  return face;
}

/// Returns a face at a time from 0 to 1; `room` is for one in between two poses.
const ShapeFace& face_at(const Group& group, unsigned primitive, float time, ShapeFace& room) {
  const std::size_t face = group.face_of(primitive);
  const std::size_t steps = group.faces.size() - 1;
  if (steps == 0) return group.faces.front()[face];
  const double at = static_cast<double>(time) * static_cast<double>(steps);
  const auto step = std::min(static_cast<std::size_t>(std::max(at, 0.0)), steps - 1);
  room =
      between(group.faces[step][face], group.faces[step + 1][face], at - static_cast<double>(step));
  return room;
}

float below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}

float above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

void bound_face(const RTCBoundsFunctionArguments* args) {
  const TaskOrder::Task task;
  const auto& group = *static_cast<const Group*>(args->geometryUserPtr);
  const std::size_t pose = std::min<std::size_t>(args->timeStep, group.faces.size() - 1);
  const FaceBounds box = bounds_of(group.faces[pose][group.face_of(args->primID)]);
  const double scale = group.scale;
  // Embree computes distances to boxes in single precision, so a flat face needs a box with some
  // thickness.
  const glm::dvec3 pad = 4e-7 * (glm::abs(box.lo) + glm::abs(box.hi) + (box.hi - box.lo));
  RTCBounds& out = *args->bounds_o;
  out.lower_x = below((box.lo.x - pad.x) * scale);
  out.lower_y = below((box.lo.y - pad.y) * scale);
  out.lower_z = below((box.lo.z - pad.z) * scale);
  out.upper_x = above((box.hi.x + pad.x) * scale);
  out.upper_y = above((box.hi.y + pad.y) * scale);
  out.upper_z = above((box.hi.z + pad.z) * scale);
}

/// Calls `accept(ray, hit)` for each hit of the ray with the face, the nearest first, until one is
/// accepted. During the call, `ray.tfar` is the hit's distance.
template <typename Accept>
void offer(const Group& group, unsigned primitive, float scale, RTCRay& ray, Accept accept) {
  ShapeFace room;
  const ShapeFace& face = face_at(group, primitive, ray.time, room);
  const double per_scale = 1.0 / static_cast<double>(scale);
  const FaceCrossings met = cross(face, per_scale * glm::dvec3(ray.org_x, ray.org_y, ray.org_z),
                                  glm::dvec3(ray.dir_x, ray.dir_y, ray.dir_z));
  const float far = ray.tfar;
  for (int i = 0; i < met.count; ++i) {
    const auto t = static_cast<float>(met.t[i] * static_cast<double>(scale));
    if (!(t > ray.tnear && t <= far)) continue;
    const glm::dvec2 uv = face_coordinates(face, met.unit[i]);
    RTCHit hit{};
    hit.u = static_cast<float>(uv.x);
    hit.v = static_cast<float>(uv.y);
    ray.tfar = t;
    if (accept(ray, hit)) return;
    ray.tfar = far;
  }
}

void fill(RTCHit& hit, unsigned geometry, unsigned primitive, const RTCIntersectContext* context) {
  hit.geomID = geometry;
  hit.primID = primitive;
  hit.instID[0] = context->instID[0];
}

RTCFilterFunctionNArguments filter_arguments(int* valid, void* user, RTCIntersectContext* context,
                                             RTCRay& ray, RTCHit& hit) {
  RTCFilterFunctionNArguments args;
  args.valid = valid;
  args.geometryUserPtr = user;
  args.context = context;
  args.ray = reinterpret_cast<RTCRayN*>(&ray);
  args.hit = reinterpret_cast<RTCHitN*>(&hit);
  args.N = 1;
  return args;
}

void intersect_face(const RTCIntersectFunctionNArguments* args) {
  const auto& group = *static_cast<const Group*>(args->geometryUserPtr);
  const float scale = reinterpret_cast<const Context*>(args->context)->scale;
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    RTCRay one = rtcGetRayFromRayN(rays, args->N, i);
    offer(group, args->primID, scale, one, [&](RTCRay& ray, RTCHit& hit) {
      fill(hit, args->geomID, args->primID, args->context);
      int valid = -1;
      const auto filtered =
          filter_arguments(&valid, args->geometryUserPtr, args->context, ray, hit);
      rtcFilterIntersection(args, &filtered);
      if (valid != -1) return false;
      RTCRayN_tfar(rays, args->N, i) = ray.tfar;
      RTCHitN_u(hits, args->N, i) = hit.u;
      RTCHitN_v(hits, args->N, i) = hit.v;
      RTCHitN_primID(hits, args->N, i) = hit.primID;
      RTCHitN_geomID(hits, args->N, i) = hit.geomID;
      RTCHitN_instID(hits, args->N, i, 0) = hit.instID[0];
      return true;
    });
  }
}

void occlude_face(const RTCOccludedFunctionNArguments* args) {
  const auto& group = *static_cast<const Group*>(args->geometryUserPtr);
  const float scale = reinterpret_cast<const Context*>(args->context)->scale;
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    RTCRay one = rtcGetRayFromRayN(args->ray, args->N, i);
    offer(group, args->primID, scale, one, [&](RTCRay& ray, RTCHit& hit) {
      fill(hit, args->geomID, args->primID, args->context);
      int valid = -1;
      const auto filtered =
          filter_arguments(&valid, args->geometryUserPtr, args->context, ray, hit);
      rtcFilterOcclusion(args, &filtered);
      if (valid != -1) return false;
      RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
      return true;
    });
  }
}

}  // namespace

void set_faces(RTCGeometry geometry, Group& group) {
  rtcSetGeometryUserPrimitiveCount(geometry, group.count);
  rtcSetGeometryUserData(geometry, &group);
  rtcSetGeometryBoundsFunction(geometry, bound_face, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_face);
  rtcSetGeometryOccludedFunction(geometry, occlude_face);
}

}  // namespace asos::tracing
