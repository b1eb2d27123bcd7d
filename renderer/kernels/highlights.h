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
  Lanes half_angle_tangent;
};

/// Returns the highlight in the direction of an offset, or along the ray if the offset is zero.
HWY_INLINE HighlightLanes towards_offset(const Vectors& offset, float radius, const Vectors& ray) {
  const Offset at = towards_point(offset);
  HighlightLanes highlight{select(at.apart, at.sample.direction, ray), hn::Zero(FloatTag())};
  if (radius > 0.0f) {
    // Points inside of the ball are treated as on its surface.
    const auto r = all_lanes(radius);
    highlight.half_angle_tangent = hn::Div(r, hn::Max(at.sample.distance, r));
  }
  return highlight;
}

/// Returns the point of a ball around `middle` that is nearest to the ray.
HWY_INLINE Vectors nearest_of_ball(const Vectors& middle, Lanes radius, const Vectors& ray) {
  const auto along = hn::Max(hn::Zero(FloatTag()), dot(middle, ray));
  const Vectors to_ray = scaled(along, ray) - middle;
  const auto length = hn::Sqrt(dot(to_ray, to_ray));
  const auto far = hn::Gt(length, radius);
  const auto part = hn::IfThenElse(
      far, hn::Div(radius, hn::IfThenElse(far, length, all_lanes(1.0f))), all_lanes(1.0f));
  return middle + scaled(part, to_ray);
}

HWY_INLINE HighlightLanes ball_highlight(const LightConstants& light, const Vectors& middle,
                                         const Vectors& ray) {
  const auto radius = all_lanes(light.radius);
  const auto distance = hn::Sqrt(dot(middle, middle));
  const auto inside = hn::Le(distance, radius);
  HighlightLanes highlight =
      towards_offset(nearest_of_ball(middle, radius, ray), light.radius, ray);
  const auto one = all_lanes(1.0f);
  highlight.half_angle_tangent =
      hn::IfThenElse(inside, one, hn::Div(radius, hn::IfThenElse(inside, one, distance)));
  highlight.direction = select(inside, ray, highlight.direction);
  return highlight;
}

/// Returns the point of a segment or of a capsule's axis that is nearest to the ray's line.
HWY_INLINE Vectors nearest_of_axis(const LightConstants& light, const Vectors& middle,
                                   const Vectors& ray) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors half = all_lanes(light.half_u);
  const auto ray_middle = dot(ray, middle);
  const auto ray_half = dot(ray, half);
  const auto across2 = hn::Sub(dot(half, half), hn::Mul(ray_half, ray_half));
  const auto wanted = hn::Sub(hn::Mul(ray_middle, ray_half), dot(middle, half));
  const auto crosses = hn::Gt(across2, zero);
  const auto t = hn::IfThenElseZero(
      crosses, clamped(hn::Div(wanted, hn::IfThenElse(crosses, across2, one)), hn::Neg(one), one));
  return middle + scaled(t, half);
}

/// Returns the point of the light's plane that the ray hits, relative to `middle`; see
/// highlight_of.
HWY_INLINE Vectors plane_hit(const LightConstants& light, const Vectors& middle,
                             const Vectors& ray) {
  const auto far =
      hn::Add(hn::Sqrt(dot(middle, middle)), all_lanes(light.u_length + light.v_length));
  const Vectors towards = all_lanes(light.towards);
  const auto along = dot(middle, towards);
  const auto slope = dot(ray, towards);
  const auto hits = hn::And(hn::Gt(hn::Mul(along, slope), hn::Zero(FloatTag())),
                            hn::Lt(hn::Abs(along), hn::Mul(far, hn::Abs(slope))));
  const auto t =
      hn::IfThenElse(hits, hn::Div(along, hn::IfThenElse(hits, slope, all_lanes(1.0f))), far);
  return scaled(t, ray) - middle;
}

HWY_INLINE Vectors nearest_of_disk(const LightConstants& light, const Vectors& hit) {
  const auto one = all_lanes(1.0f);
  const Vectors towards = all_lanes(light.towards);
  const Vectors flat = hit - scaled(dot(hit, towards), towards);
  const auto length = hn::Sqrt(dot(flat, flat));
  const auto radius = all_lanes(light.radius);
  const auto beyond = hn::Gt(length, radius);
  return scaled(hn::IfThenElse(beyond, hn::Div(radius, hn::IfThenElse(beyond, length, one)), one),
                flat);
}
HWY_INLINE Vectors nearest_of_bounds(const LightConstants& light, const Vectors& hit) {
  const Vectors u_axis = all_lanes(light.u_axis), v_axis = all_lanes(light.v_axis);
  const auto u = clamped(dot(hit, u_axis), all_lanes(-light.u_length), all_lanes(light.u_length));
  const auto v = clamped(dot(hit, v_axis), all_lanes(-light.v_length), all_lanes(light.v_length));
  return scaled(u, u_axis) + scaled(v, v_axis);
}

// `ray` is the reflected view direction.
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::point>, const LightConstants&,
                                    const Vectors& middle, const Vectors& ray) {
  return towards_offset(middle, 0.0f, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::distant>, const LightConstants& light,
                                    const Vectors&, const Vectors&) {
  return {all_lanes(light.towards), hn::Zero(FloatTag())};
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::ball>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  return ball_highlight(light, middle, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::sun>, const LightConstants& light,
                                    const Vectors&, const Vectors& ray) {
  const auto radius = all_lanes(light.radius);
  const Vectors nearest = nearest_of_ball(all_lanes(light.towards), radius, ray);
  return {towards_offset(nearest, 0.0f, ray).direction, radius};
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::segment>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  return towards_offset(nearest_of_axis(light, middle, ray), light.highlight_radius, ray);
}
HWY_INLINE HighlightLanes highlight(ShapeTag<LightShape::capsule>, const LightConstants& light,
                                    const Vectors& middle, const Vectors& ray) {
  const Vectors ball = nearest_of_axis(light, middle, ray);
  return towards_offset(nearest_of_ball(ball, all_lanes(light.radius), ray), light.highlight_radius,
                        ray);
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
