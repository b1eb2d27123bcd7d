// Geometry of lights that scalar code and kernels share, as templates on a vector type V:
// glm::dvec3, or Vec3 of lanes (renderer/kernels/simd_math.h). A `Light` is a PreparedLight or its
// LightConstants. Included once; where Highway is included before, once for each instruction set.
#if defined(ASOS_LIGHTS_KINDS_SHARED_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_LIGHTS_KINDS_SHARED_H
#undef ASOS_LIGHTS_KINDS_SHARED_H
#else
#define ASOS_LIGHTS_KINDS_SHARED_H
#endif

#include "renderer/lights/lane_choices.h"
#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#ifdef HWY_NAMESPACE
HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
#else
namespace asos {
#endif

/// What all shapes have: `highlight`, as highlight_of. `ray` is the reflected view direction.
template <LightShape shape>
struct SharedGeometry;

/// As Highlight.
template <class V>
struct HighlightOf {
  V direction;
  decltype(V::x) half_angle_tangent = 0.0;
  decltype(V::x) distance = std::numeric_limits<float>::infinity();
};
template <class V, class... Numbers>
HighlightOf(V, Numbers...) -> HighlightOf<V>;

/// Returns the highlight of a point with a radius, or along the ray if the point is the receiver.
ASOS_INLINE auto highlight_towards(const auto& to_point, auto radius, const auto& ray) {
  using std::max;
  const auto distance = length(to_point);
  const auto apart = distance > 0.0;
  HighlightOf highlight{selected(apart, to_point / selected(apart, distance, 1.0), ray)};
  highlight.distance = distance;
  // Points inside of the radius are treated as on the surface of a ball.
  if (radius > 0) highlight.half_angle_tangent = radius / max(distance, radius);
  return highlight;
}

/// Returns the nearest point of a ball (or of a sun at the distance 1): at most a radius from its
/// centre towards the ray.
ASOS_INLINE auto nearest_of_ball(const auto& to_middle, auto radius, const auto& ray) {
  using std::max;
  // A ray that leads away is nearest where it starts.
  const auto to_ray = max(0.0, dot(to_middle, ray)) * ray - to_middle;
  const auto distance = length(to_ray);
  const auto far = distance > radius;
  return to_middle + selected(far, radius / selected(far, distance, 1.0), 1.0) * to_ray;
}

/// Returns the point of a segment, or of a capsule's axis, with the least distance to a ray's line.
ASOS_INLINE auto nearest_of_axis(const auto& light, const auto& to_middle, const auto& ray) {
  using std::clamp;
  const auto ray_half = dot(ray, light.half_u);
  const auto across2 = dot(light.half_u, light.half_u) - ray_half * ray_half;
  const auto wanted = dot(ray, to_middle) * ray_half - dot(to_middle, light.half_u);
  const auto crosses = across2 > 0.0;
  const auto t = where(crosses, clamp(wanted / selected(crosses, across2, 1.0), -1.0, 1.0));
  return to_middle + t * light.half_u;
}

template <>
struct SharedGeometry<LightShape::point> {
  static ASOS_INLINE auto highlight(const auto&, const auto& to_middle, const auto& ray) {
    return highlight_towards(to_middle, 0.0, ray);
  }
};

template <>
struct SharedGeometry<LightShape::distant> {
  template <class V>
  static ASOS_INLINE auto highlight(const auto& light, const V&, const V&) {
    return HighlightOf{V(light.towards)};
  }
};

template <>
struct SharedGeometry<LightShape::ball> {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto distance = length(to_middle);
    const auto inside = distance <= light.radius;
    const auto nearest = nearest_of_ball(to_middle, light.radius, ray);
    return HighlightOf{selected(inside, ray, highlight_towards(nearest, 0.0, ray).direction),
                       selected(inside, 1.0, light.radius / selected(inside, 1.0, distance)),
                       where(!inside, distance - light.radius)};
  }
};

template <>
struct SharedGeometry<LightShape::sun> {
  template <class V>
  static ASOS_INLINE auto highlight(const auto& light, const V&, const V& ray) {
    const V nearest = nearest_of_ball(V(light.towards), light.radius, ray);
    return HighlightOf{highlight_towards(nearest, 0.0, ray).direction, light.radius};
  }
};

template <>
struct SharedGeometry<LightShape::segment> {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    return highlight_towards(nearest_of_axis(light, to_middle, ray), light.highlight_radius, ray);
  }
};

template <>
struct SharedGeometry<LightShape::capsule> {
  /// At the axis point with the least distance to the ray's line, moved towards the ray.
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto ball = nearest_of_axis(light, to_middle, ray);
    return highlight_towards(nearest_of_ball(ball, light.radius, ray), light.highlight_radius, ray);
  }
};

/// Shared by the shapes in a plane. `Shape` has `nearest`, to a point relative to the centre.
template <class Shape>
struct SharedFlat {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto nearest = Shape::nearest(light, plane_hit(light, to_middle, ray));
    return highlight_towards(to_middle + nearest, light.highlight_radius, ray);
  }
  /// Returns the nearest point of the bounding rectangle.
  static ASOS_INLINE auto nearest(const auto& light, const auto& hit) {
    using std::clamp;
    return clamp(dot(hit, light.u_axis), -light.u_length, light.u_length) * light.u_axis +
           clamp(dot(hit, light.v_axis), -light.v_length, light.v_length) * light.v_axis;
  }

 private:
  /// Returns the point where the mirrored ray hits the light's plane, relative to `to_middle`. If
  /// the ray hits the plane beyond the whole light, or not at all, the ray's far end is used
  /// instead, so that the point moves continuously as the ray turns away.
  static ASOS_INLINE auto plane_hit(const auto& light, const auto& to_middle, const auto& ray) {
    using std::abs;
    const auto far = length(to_middle) + light.u_length + light.v_length;
    const auto along = dot(to_middle, light.towards), slope = dot(ray, light.towards);
    const auto hits = along * slope > 0.0 && abs(along) < far * abs(slope);
    return selected(hits, along / selected(hits, slope, 1.0), far) * ray - to_middle;
  }
};

template <>
struct SharedGeometry<LightShape::rectangle> : SharedFlat<SharedGeometry<LightShape::rectangle>> {};

template <>
struct SharedGeometry<LightShape::polygon> : SharedFlat<SharedGeometry<LightShape::polygon>> {};

template <>
struct SharedGeometry<LightShape::disk> : SharedFlat<SharedGeometry<LightShape::disk>> {
  static ASOS_INLINE auto nearest(const auto& light, const auto& hit) {
    const auto flat = hit - dot(hit, light.towards) * light.towards;
    const auto distance = length(flat);
    const auto beyond = distance > light.radius;
    return selected(beyond, light.radius / selected(beyond, distance, 1.0), 1.0) * flat;
  }
};

#ifdef HWY_NAMESPACE
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
}  // namespace asos
#endif

#endif
