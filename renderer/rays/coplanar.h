#pragma once

#include "renderer/rays/filters.h"
#include "renderer/world/world.h"

#include <embree3/rtcore.h>

#include <cstdint>
#include <span>
#include <vector>

// Triangles of different parts that lie in one plane and overlap, such as decals. A ray meets them
// in one place, where rounding alone would choose the nearest. Internal to this folder.

namespace asos::tracing {

/// By triangle, 1 where one of another part lies in its plane and overlaps it; empty: nowhere.
/// `scene` is committed. Triangles that meet too many others to be compared are marked, too, which
/// costs time and changes no picture.
[[nodiscard]] std::vector<std::uint8_t> find_coplanar(const World& world, RTCScene scene,
                                                      const Group* groups, float scale);

/// How far beside a ray's hit on a triangle those lie that it meets in the same place, along the
/// ray.
[[nodiscard]] float reach_of_hit(const World& world, const Ray& ray, const Hit& hit);

/// Returns whether the first of two hits in the same place is in front. Blended and cut-out
/// surfaces are in front of opaque ones; within a kind the later primitive of the file is.
[[nodiscard]] bool in_front(const World& world, const Hit& a, const Hit& b);

/// The filter of a context that collects all hits into Context::met, and keeps none.
void collecting_filter(const RTCFilterFunctionNArguments* args);

}  // namespace asos::tracing
