// The representative point of a light for its highlight, as highlight_of, with one point per lane.
// Included once for each instruction set.
#if defined(ASOS_KERNELS_HIGHLIGHTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_HIGHLIGHTS_H
#undef ASOS_KERNELS_HIGHLIGHTS_H
#else
#define ASOS_KERNELS_HIGHLIGHTS_H
#endif

#include "renderer/kernels/light_samples.h"

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
struct HighlightLanes {
  Vectors direction;
  Lane half_angle_tangent;
};

/// Returns the highlight in the direction of an offset, or along the ray if the offset is zero.
HWY_INLINE HighlightLanes towards_offset(const Vectors& offset, float radius, const Vectors& ray) {
  const Offset at = towards_point(offset);
  HighlightLanes highlight{selected(at.apart, at.sample.direction, ray), 0.0f};
  if (radius > 0.0f) {
    // Points inside of the ball are treated as on its surface.
    const auto r = radius;
    highlight.half_angle_tangent = r / max(at.sample.distance, r);
  }
  return highlight;
}

/// Returns the point of a ball around `middle` that is nearest to the ray.
HWY_INLINE Vectors nearest_of_ball(const Vectors& middle, Lane radius, const Vectors& ray) {
  const auto along = max(0.0f, dot(middle, ray));
  const Vectors to_ray = along * ray - middle;
  const auto length = sqrt(dot(to_ray, to_ray));
  const auto far = length > radius;
  const auto part = selected(far, radius / selected(far, length, 1.0f), 1.0f);
  return middle + part * to_ray;
}

HWY_INLINE HighlightLanes ball_highlight(const LightConstants& light, const Vectors& middle,
                                         const Vectors& ray) {
  const auto radius = light.radius;
  const auto distance = sqrt(dot(middle, middle));
  const auto inside = distance <= radius;
  HighlightLanes highlight =
      towards_offset(nearest_of_ball(middle, radius, ray), light.radius, ray);
  highlight.half_angle_tangent = selected(inside, 1.0f, radius / selected(inside, 1.0f, distance));
  highlight.direction = selected(inside, ray, highlight.direction);
  return highlight;
}

/// Returns the point of a segment or of a capsule's axis that is nearest to the ray's line.
HWY_INLINE Vectors nearest_of_axis(const LightConstants& light, const Vectors& middle,
                                   const Vectors& ray) {
  const Vectors half = light.half_u;
  const auto ray_middle = dot(ray, middle);
  const auto ray_half = dot(ray, half);
  const auto across2 = dot(half, half) - ray_half * ray_half;
  const auto wanted = ray_middle * ray_half - dot(middle, half);
  const auto crosses = across2 > 0.0f;
  const auto t = where(crosses, clamp(wanted / selected(crosses, across2, 1.0f), -1.0f, 1.0f));
  return middle + t * half;
}

/// Returns the point of the light's plane that the ray hits, relative to `middle`; see
/// highlight_of.
HWY_INLINE Vectors plane_hit(const LightConstants& light, const Vectors& middle,
                             const Vectors& ray) {
  const auto far = sqrt(dot(middle, middle)) + (light.u_length + light.v_length);
  const Vectors towards = light.towards;
  const auto along = dot(middle, towards);
  const auto slope = dot(ray, towards);
  const auto hits = along * slope > 0.0f && abs(along) < far * abs(slope);
  const auto t = selected(hits, along / selected(hits, slope, 1.0f), far);
  return t * ray - middle;
}

HWY_INLINE Vectors nearest_of_disk(const LightConstants& light, const Vectors& hit) {
  const Vectors towards = light.towards;
  const Vectors flat = hit - dot(hit, towards) * towards;
  const auto length = sqrt(dot(flat, flat));
  const auto radius = light.radius;
  const auto beyond = length > radius;
  return selected(beyond, radius / selected(beyond, length, 1.0f), 1.0f) * flat;
}
HWY_INLINE Vectors nearest_of_bounds(const LightConstants& light, const Vectors& hit) {
  const Vectors u_axis = light.u_axis, v_axis = light.v_axis;
  const auto u = clamp(dot(hit, u_axis), -light.u_length, light.u_length);
  const auto v = clamp(dot(hit, v_axis), -light.v_length, light.v_length);
  return u * u_axis + v * v_axis;
}

// `ray` is the reflected view direction.
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::point>, const LightConstants&,
                                    const Vectors& middle, const Vectors& ray) {
  return towards_offset(middle, 0.0f, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::distant>, const LightConstants& light,
                                    const Vectors&, const Vectors&) {
  return {light.towards, 0.0f};
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::ball>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  return ball_highlight(light, middle, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::sun>, const LightConstants& light,
                                    const Vectors&, const Vectors& ray) {
  const auto radius = light.radius;
  const Vectors nearest = nearest_of_ball(light.towards, radius, ray);
  return {towards_offset(nearest, 0.0f, ray).direction, radius};
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::segment>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  return towards_offset(nearest_of_axis(light, middle, ray), light.highlight_radius, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::capsule>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  const Vectors ball = nearest_of_axis(light, middle, ray);
  return towards_offset(nearest_of_ball(ball, light.radius, ray), light.highlight_radius, ray);
}
template <LightShape shape>
requires(traits_of(shape).flat) HWY_INLINE HighlightLanes
    highlight(ShapeTag<shape>, const LightConstants& light, const Vectors& middle,
              const Vectors& ray) {
  const Vectors hit = plane_hit(light, middle, ray);
  const Vectors nearest =
      shape == LightShape::disk ? nearest_of_disk(light, hit) : nearest_of_bounds(light, hit);
  return towards_offset(middle + nearest, light.highlight_radius, ray);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
