#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/rays/filters.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>

// Embree's calls for 1, 4, 8 and 16 rays under one name. Internal to this folder.

namespace asos::tracing {

template <int width>
struct Packet;
template <>
struct Packet<1> {
  using Rays = RTCRay;
  using RayHits = RTCRayHit;
  static void intersect(const int*, RTCScene scene, RTCIntersectContext* context, RayHits* query) {
    rtcIntersect1(scene, context, query);
  }
  static void occluded(const int*, RTCScene scene, RTCIntersectContext* context, Rays* query) {
    rtcOccluded1(scene, context, query);
  }
};
template <>
struct Packet<4> {
  using Rays = RTCRay4;
  using RayHits = RTCRayHit4;
  static constexpr auto intersect = rtcIntersect4;
  static constexpr auto occluded = rtcOccluded4;
};
template <>
struct Packet<8> {
  using Rays = RTCRay8;
  using RayHits = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct Packet<16> {
  using Rays = RTCRay16;
  using RayHits = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
};

/// Returns a lane of a packet's field; a single ray's fields are plain numbers.
template <typename T>
[[nodiscard]] auto& lane_of(T& field, std::size_t lane) {
  if constexpr (std::is_array_v<T>) {
    return field[lane];
  } else {
    return field;
  }
}

/// The largest number that Embree accepts in a ray's origin and direction, slightly below its own
/// limit of 1.844e18. Beyond that, Debian's build ends the program.
inline constexpr float largest_traceable = 1.8e18f;

/// Returns whether Embree accepts a ray; the origin is converted to Embree's lengths by `scale`.
[[nodiscard]] inline bool traceable(const Ray& ray, float scale) {
  // Test sums of magnitudes, which are at least as large as each term; that saves five of six tests
  // in the hot path. A start behind the origin ends the program, too.
  const glm::vec3 o = glm::abs(ray.origin * scale), d = glm::abs(ray.direction);
  const float turn = d.x + d.y + d.z;
  return o.x + o.y + o.z + turn <= largest_traceable && turn > 0.0f && ray.t_near >= 0.0f &&
         !std::isnan(ray.t_far);
}

template <typename Rays>
void load(Rays& rays, std::size_t lane, const Ray& ray, float scale, float time) {
  lane_of(rays.org_x, lane) = ray.origin.x * scale;
  lane_of(rays.org_y, lane) = ray.origin.y * scale;
  lane_of(rays.org_z, lane) = ray.origin.z * scale;
  lane_of(rays.tnear, lane) = ray.t_near * scale;
  lane_of(rays.dir_x, lane) = ray.direction.x;
  lane_of(rays.dir_y, lane) = ray.direction.y;
  lane_of(rays.dir_z, lane) = ray.direction.z;
  lane_of(rays.tfar, lane) = ray.t_far * scale;
  lane_of(rays.time, lane) = time;
  lane_of(rays.mask, lane) = ~0u;
  lane_of(rays.id, lane) = static_cast<unsigned>(lane);
  lane_of(rays.flags, lane) = 0u;
}

/// Traces a packet through the layers of a scene in turn: each one shortens the rays.
template <int width>
void intersect_layers(const int* valid, std::span<const RTCScene> layers, Context& context,
                      typename Packet<width>::RayHits& query) {
  for (const RTCScene layer : layers) Packet<width>::intersect(valid, layer, &context.base, &query);
}

/// Embree's mark of a blocked ray: its far end.
inline constexpr float far_end_of_blocked = -std::numeric_limits<float>::infinity();

/// Does so for occlusion. Blocked rays are not traced further; `valid` is changed.
template <int width>
void occlude_layers(int* valid, std::span<const RTCScene> layers, Context& context,
                    typename Packet<width>::Rays& query) {
  for (std::size_t k = 0; k < layers.size(); ++k) {
    bool any = false;
    for (std::size_t i = 0; i < width; ++i) {
      if (k > 0 && lane_of(query.tfar, i) == far_end_of_blocked) valid[i] = 0;
      any = any || valid[i] != 0;
    }
    if (!any) return;
    Packet<width>::occluded(valid, layers[k], &context.base, &query);
  }
}

/// Finds the nearest hits. Calls `store(i, lane, hit)` for each ray i, after its packet is done and
/// before the next packet uses the context's lanes.
template <int width, typename Store>
void intersect_packets(std::span<const RTCScene> layers, Context& context,
                       std::span<const Ray> rays, Store store) {
  constexpr std::size_t lanes = width;
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::size_t count = std::min(lanes, rays.size() - first);
    alignas(64) std::array<int, lanes> valid{};
    alignas(64) typename Packet<width>::RayHits query;
    if (count < lanes) query = {};
    for (std::size_t i = 0; i < count; ++i) {
      valid[i] = traceable(rays[first + i], context.scale) ? -1 : 0;
      load(query.ray, i, rays[first + i], context.scale, context.time_of(first + i));
      lane_of(query.hit.geomID, i) = RTC_INVALID_GEOMETRY_ID;
    }
    if (context.lanes) context.lanes->reset();
    if (width > 1 || valid[0]) intersect_layers<width>(valid.data(), layers, context, query);
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned geometry = lane_of(query.hit.geomID, i);
      if (!valid[i] || geometry == RTC_INVALID_GEOMETRY_ID) {
        store(first + i, i, Hit{});
        continue;
      }
      store(first + i, i,
            context.geometries.hit(geometry, lane_of(query.hit.primID, i),
                                   lane_of(query.hit.instID[0], i),
                                   lane_of(query.ray.tfar, i) / context.scale,
                                   lane_of(query.hit.u, i), lane_of(query.hit.v, i)));
    }
  }
}

/// Tests whether anything blocks the rays. Calls `store(i, lane, blocked)`, as intersect_packets
/// does.
template <int width, typename Store>
void occlude_packets(std::span<const RTCScene> layers, Context& context, std::span<const Ray> rays,
                     Store store) {
  constexpr std::size_t lanes = width;
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::size_t count = std::min(lanes, rays.size() - first);
    alignas(64) std::array<int, lanes> valid{};
    alignas(64) typename Packet<width>::Rays query;
    if (count < lanes) query = {};
    for (std::size_t i = 0; i < count; ++i) {
      const Ray& ray = rays[first + i];
      valid[i] = traceable(ray, context.scale) && ray.t_far != far_end_of_blocked ? -1 : 0;
      load(query, i, ray, context.scale, context.time_of(first + i));
    }
    if (context.lanes) context.lanes->reset();
    alignas(64) auto asked = valid;
    occlude_layers<width>(asked.data(), layers, context, query);
    for (std::size_t i = 0; i < count; ++i) {
      store(first + i, i, valid[i] != 0 && lane_of(query.tfar, i) == far_end_of_blocked);
    }
  }
}

/// Copies `lanes` numbers, times `scale`.
template <std::size_t lanes>
void copy_scaled(const float* __restrict from, float scale, float* __restrict to) {
  for (std::size_t i = 0; i < lanes; ++i) to[i] = from[i] * scale;
}

/// Loads rays from `first` on into the lanes. Lanes beyond the last ray are undefined and not
/// valid.
template <std::size_t lanes, typename Rays>
void load(Rays& query, std::array<int, lanes>& valid, const RayArrays& rays, std::size_t first,
          float scale) {
  const std::size_t count = std::min(lanes, rays.count - first);
  copy_scaled<lanes>(rays.origin[0] + first, scale, &lane_of(query.org_x, 0));
  copy_scaled<lanes>(rays.origin[1] + first, scale, &lane_of(query.org_y, 0));
  copy_scaled<lanes>(rays.origin[2] + first, scale, &lane_of(query.org_z, 0));
  copy_scaled<lanes>(rays.direction[0] + first, 1.0f, &lane_of(query.dir_x, 0));
  copy_scaled<lanes>(rays.direction[1] + first, 1.0f, &lane_of(query.dir_y, 0));
  copy_scaled<lanes>(rays.direction[2] + first, 1.0f, &lane_of(query.dir_z, 0));
  copy_scaled<lanes>(rays.t_far + first, scale, &lane_of(query.tfar, 0));
  for (std::size_t i = 0; i < lanes; ++i) {
    lane_of(query.tnear, i) = 0.0f;
    lane_of(query.time, i) = 0.0f;
    lane_of(query.mask, i) = ~0u;
    lane_of(query.id, i) = static_cast<unsigned>(i);
    lane_of(query.flags, i) = 0u;
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    // As in `traceable`: a direction of length 1 is not 0.
    const float sum = std::abs(lane_of(query.org_x, i)) + std::abs(lane_of(query.org_y, i)) +
                      std::abs(lane_of(query.org_z, i)) + std::abs(lane_of(query.dir_x, i)) +
                      std::abs(lane_of(query.dir_y, i)) + std::abs(lane_of(query.dir_z, i));
    const int sound =
        int{sum <= largest_traceable} & int{lane_of(query.tfar, i) >= 0.0f} & int{i < count};
    valid[i] = -sound;
  }
}

/// Does so for rays in arrays.
template <int width, typename Store>
void occlude_packets(std::span<const RTCScene> layers, Context& context, const RayArrays& rays,
                     Store store) {
  constexpr std::size_t lanes = width;
  for (std::size_t first = 0; first < rays.count; first += lanes) {
    const std::size_t count = std::min(lanes, rays.count - first);
    alignas(64) std::array<int, lanes> valid;
    alignas(64) typename Packet<width>::Rays query;
    load(query, valid, rays, first, context.scale);
    if (context.lanes) context.lanes->reset();
    alignas(64) auto asked = valid;
    occlude_layers<width>(asked.data(), layers, context, query);
    for (std::size_t i = 0; i < count; ++i)
      store(first + i, i, valid[i] != 0 && lane_of(query.tfar, i) == far_end_of_blocked);
  }
}

/// Calls `work` with the width as a compile-time constant; a single ray goes alone.
template <typename Work>
void with_width(int width, std::size_t rays, Work work) {
  if (width == 1 || rays == 1) {
    work(std::integral_constant<int, 1>{});
  } else if (width == 4) {
    work(std::integral_constant<int, 4>{});
  } else if (width == 8) {
    work(std::integral_constant<int, 8>{});
  } else {
    work(std::integral_constant<int, 16>{});
  }
}

}  // namespace asos::tracing
