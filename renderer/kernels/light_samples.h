// Samples on a light, as sample_light, with one point per lane. Included once for each instruction
// set.
#if defined(ASOS_KERNELS_LIGHT_SAMPLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LIGHT_SAMPLES_H
#undef ASOS_KERNELS_LIGHT_SAMPLES_H
#else
#define ASOS_KERNELS_LIGHT_SAMPLES_H
#endif

#include "renderer/kernels/arc_places.h"

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

struct ReceiverLanes {
  Vectors position, geometric, normal;
};

/// As LightSample. The light's power times `form` is the irradiance.
struct SampleLanes {
  Vectors direction;
  Lanes distance;
  Lanes form;
};

/// Maps 0 to 1 onto -1 to 1, with one rounding.
HWY_INLINE Lanes centred(const std::uint32_t* from) {
  const hn::RebindToSigned<FloatTag> di;
  const auto bits = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(from));
  const auto moved = hn::Xor(bits, hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  return hn::Mul(hn::ConvertTo(FloatTag(), moved), all_lanes(1.0f / 2147483648.0f));
}

struct DiskPlaces {
  Lanes x, y;
};
/// Maps the square from -1 to 1 onto the unit disk. Preserves areas and neighbourhoods (Shirley and
/// Chiu 1997).
HWY_INLINE DiskPlaces concentric(Lanes a, Lanes b) {
  const FloatTag d;
  const auto wide = hn::Gt(hn::Abs(a), hn::Abs(b));
  const auto r = hn::IfThenElse(wide, a, b);
  const auto other = hn::IfThenElse(wide, b, a);
  const auto none = hn::Eq(r, hn::Zero(d));
  const auto quotient = hn::Div(other, hn::IfThenElse(none, all_lanes(1.0f), r));
  const auto turn =
      sin_cos_of_eighth(d, hn::Mul(all_lanes(0.25f * std::numbers::pi_v<float>), quotient));
  const auto near = hn::Mul(r, turn.cos), far = hn::Mul(r, turn.sin);
  return {hn::IfThenElse(wide, near, far), hn::IfThenElse(wide, far, near)};
}

/// Returns a unit vector perpendicular to a unit one, as any_perpendicular.
HWY_INLINE Vectors any_perpendicular(const Vectors& axis) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto by_x = hn::Lt(hn::Abs(axis.x), all_lanes(0.6f));
  const Vectors across{hn::IfThenElse(by_x, zero, axis.z),
                       hn::IfThenElse(by_x, hn::Neg(axis.z), zero),
                       hn::IfThenElse(by_x, axis.y, hn::Neg(axis.x))};
  return scaled(hn::Div(all_lanes(1.0f), hn::Sqrt(dot(across, across))), across);
}

HWY_INLINE Lanes cosine_above(const Vectors& direction, const ReceiverLanes& receiver) {
  const auto zero = hn::Zero(FloatTag());
  const auto above = hn::Gt(dot(direction, receiver.geometric), zero);
  return hn::IfThenElseZero(above, hn::Max(dot(direction, receiver.normal), zero));
}

/// A point of the light at `offset` from the receiver; its form factor is set later. At the
/// receiver itself it has no direction.
struct Offset {
  SampleLanes sample;
  Lanes nearness;  ///< 1 / distance
  LaneMask apart;
};
HWY_INLINE Offset towards_point(const Vectors& offset) {
  const auto zero = hn::Zero(FloatTag());
  const auto distance = hn::Sqrt(dot(offset, offset));
  const auto apart = hn::Gt(distance, zero);
  const auto nearness = hn::Div(all_lanes(1.0f), hn::IfThenElse(apart, distance, all_lanes(1.0f)));
  return {{scaled(nearness, offset), distance, zero}, nearness, apart};
}

/// Returns a sample of a flat light that was chosen by area.
HWY_INLINE SampleLanes area_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                   const Vectors& offset) {
  Offset at = towards_point(offset);
  const auto below = dot(offset, all_lanes(light.towards));
  const auto height = light.two_sided ? hn::Abs(below) : hn::Neg(below);
  const auto faces = hn::Gt(height, all_lanes(light.thickness));
  const auto seen = hn::Mul(height, at.nearness);
  const auto facing =
      hn::Mul(hn::Mul(all_lanes(light.area), seen), cosine_above(at.sample.direction, receiver));
  at.sample.form = hn::IfThenElseZero(hn::And(at.apart, faces),
                                      hn::Mul(hn::Mul(facing, at.nearness), at.nearness));
  return at.sample;
}

/// As the function attenuation of a PreparedLight.
HWY_INLINE Lanes attenuation(const LightConstants& light, const Vectors& middle, Lanes distance,
                             Lanes nearness) {
  const auto one = all_lanes(1.0f);
  const auto r = hn::Min(hn::Mul(distance, all_lanes(light.inverse_range)), one);
  const auto r2 = hn::Mul(r, r);
  const auto by_range = hn::Sub(one, hn::Mul(r2, r2));
  if (!(light.cone_scale > 0.0f)) return by_range;
  const auto cosine = hn::Mul(dot(middle, all_lanes(light.towards)), nearness);
  const auto cone =
      clamped(hn::Add(hn::Mul(cosine, all_lanes(light.cone_scale)), all_lanes(light.cone_offset)),
              hn::Zero(FloatTag()), one);
  return hn::Mul(by_range, hn::Mul(cone, cone));
}

HWY_INLINE SampleLanes point_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                    const Vectors& middle) {
  Offset at = towards_point(middle);
  const auto cosine = cosine_above(at.sample.direction, receiver);
  auto form = hn::Mul(hn::Mul(cosine, at.nearness), at.nearness);
  if (light.attenuates)
    form = hn::Mul(form, attenuation(light, middle, at.sample.distance, at.nearness));
  at.sample.form = hn::IfThenElseZero(at.apart, form);
  return at.sample;
}

/// Samples a direction within the cone about `axis`, uniformly by solid angle.
HWY_INLINE SampleLanes cone_sample(const ReceiverLanes& receiver, const Vectors& axis,
                                   Lanes one_less_cosine, const DiskPlaces& p) {
  const auto one = all_lanes(1.0f);
  const auto radius2 = hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y));
  const auto drop = hn::Mul(hn::Min(one, radius2), one_less_cosine);
  const auto stretch = hn::Sqrt(hn::Mul(hn::Sub(all_lanes(2.0f), drop), one_less_cosine));
  const Vectors x_axis = any_perpendicular(axis);
  const Vectors direction = scaled(hn::Sub(one, drop), axis) +
                            scaled(hn::Mul(stretch, p.x), x_axis) +
                            scaled(hn::Mul(stretch, p.y), cross(axis, x_axis));
  const auto form = hn::Mul(hn::Mul(all_lanes(2.0f * std::numbers::pi_v<float>), one_less_cosine),
                            cosine_above(direction, receiver));
  return {direction, hn::Inf(FloatTag()), form};
}

/// Samples a ball from the inside, where light arrives from all directions, by the cosine to the
/// receiver's normal.
HWY_INLINE SampleLanes inside_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                     const Vectors& middle, const DiskPlaces& p) {
  const auto zero = hn::Zero(FloatTag());
  const Vectors x_axis = any_perpendicular(receiver.normal);
  const auto radius2 = hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y));
  const auto up = hn::Sqrt(hn::Max(zero, hn::Sub(all_lanes(1.0f), radius2)));
  const Vectors direction = scaled(p.x, x_axis) + scaled(p.y, cross(receiver.normal, x_axis)) +
                            scaled(up, receiver.normal);
  const auto along = dot(direction, middle);
  const auto power =
      hn::Max(zero, hn::Sub(all_lanes(light.radius * light.radius), dot(middle, middle)));
  const auto distance = hn::Add(along, hn::Sqrt(hn::Add(hn::Mul(along, along), power)));
  const auto above = hn::Gt(dot(direction, receiver.geometric), zero);
  return {direction, distance, hn::IfThenElseZero(above, all_lanes(std::numbers::pi_v<float>))};
}

HWY_INLINE SampleLanes ball_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                   const Vectors& middle, const DiskPlaces& p) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const auto radius = all_lanes(light.radius);
  const Offset at = towards_point(middle);
  const auto sine = hn::Min(one, hn::Mul(radius, at.nearness));
  const auto cosine = hn::Sqrt(hn::Mul(hn::Sub(one, sine), hn::Add(one, sine)));
  SampleLanes sample = cone_sample(receiver, at.sample.direction,
                                   hn::Div(hn::Mul(sine, sine), hn::Add(one, cosine)), p);
  // Choose the near side of the ball. At its rim the root rounds to either side of 0.
  const auto along = dot(sample.direction, middle);
  const Vectors beside = middle - scaled(along, sample.direction);
  const auto depth2 = hn::Sub(hn::Mul(radius, radius), dot(beside, beside));
  sample.distance = hn::Sub(along, hn::Sqrt(hn::Max(zero, depth2)));
  const auto inside = hn::Le(at.sample.distance, radius);
  if (!hn::AllFalse(FloatTag(), inside)) {
    const SampleLanes within = inside_sample(light, receiver, middle, p);
    sample.direction = select(inside, within.direction, sample.direction);
    sample.distance = hn::IfThenElse(inside, within.distance, sample.distance);
    sample.form = hn::IfThenElse(inside, within.form, sample.form);
  }
  if (light.attenuates) {
    sample.form = hn::Mul(sample.form, attenuation(light, middle, at.sample.distance, at.nearness));
  }
  return sample;
}

/// `arc`: from segment_places.
HWY_INLINE SampleLanes segment_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                      const Vectors& middle, const LightArcs& arc, std::size_t i) {
  const Vectors along = all_lanes(light.u_axis);
  const Vectors foot = middle - scaled(dot(middle, along), along);
  Offset at = towards_point(foot + scaled(loaded(arc.first, i), along));
  auto form = hn::Mul(loaded(arc.second, i), cosine_above(at.sample.direction, receiver));
  if (light.lambertian) form = hn::Mul(form, hn::Mul(loaded(arc.third, i), at.nearness));
  at.sample.form = hn::IfThenElseZero(at.apart, hn::Mul(hn::Mul(form, at.nearness), at.nearness));
  return at.sample;
}

/// Whether samples of a flat light are chosen by solid angle, which has a closed form.
template <LightShape shape>
inline constexpr bool by_solid_angle = shape == LightShape::rectangle;

/// `arc`: from rectangle_places.
HWY_INLINE SampleLanes rectangle_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                        const Vectors& middle, const LightArcs& arc,
                                        const LightPointBatch& places, std::size_t i) {
  const FloatTag d;
  const auto one = all_lanes(1.0f);
  const auto v_centred = centred(&places.v[i]);
  const auto solid_angle = loaded(arc.first, i);
  const auto by_angle = hn::Gt(solid_angle, hn::Zero(d));
  SampleLanes sample;
  if (!hn::AllTrue(d, by_angle)) {
    const auto u_centred = centred(&places.u[i]);
    sample = area_sample(light, receiver,
                         middle + scaled(u_centred, all_lanes(light.half_u)) +
                             scaled(v_centred, all_lanes(light.half_v)));
    if (hn::AllFalse(d, by_angle)) return sample;
  }
  const Vectors x_axis = all_lanes(light.u_axis), y_axis = all_lanes(light.v_axis);
  const Vectors z_axis = cross(x_axis, y_axis);
  const auto x_middle = dot(middle, x_axis);
  const auto z = dot(middle, z_axis);
  const auto slope2 = loaded(arc.second, i);
  const auto per_z = hn::CopySign(hn::Div(one, hn::Sqrt(hn::Abs(slope2))), slope2);
  // At u = 0 and 1 the quotient rounds to either side of the rectangle's ends.
  const auto u_length = all_lanes(light.u_length);
  const auto x =
      clamped(hn::Mul(hn::Abs(z), per_z), hn::Sub(x_middle, u_length), hn::Add(x_middle, u_length));
  const auto y0 = loaded(arc.third, i), y1 = loaded(arc.fourth, i);
  const auto d2 = hn::Add(hn::Mul(x, x), hn::Mul(z, z));
  const auto h0 = hn::Div(y0, hn::Sqrt(hn::Add(d2, hn::Mul(y0, y0))));
  const auto h1 = hn::Div(y1, hn::Sqrt(hn::Add(d2, hn::Mul(y1, y1))));
  const auto half = all_lanes(0.5f);
  const auto v = hn::Add(hn::Mul(v_centred, half), half);
  const auto h = hn::Add(h0, hn::Mul(v, hn::Sub(h1, h0)));
  const auto h_across = hn::Sqrt(hn::Mul(hn::Sub(one, h), hn::Add(one, h)));
  const auto y = clamped(hn::Div(hn::Mul(h, hn::Sqrt(d2)), h_across), y0, y1);
  Offset at = towards_point(scaled(x, x_axis) + scaled(y, y_axis) + scaled(z, z_axis));
  at.sample.form = hn::Mul(solid_angle, cosine_above(at.sample.direction, receiver));
  if (hn::AllTrue(d, by_angle)) return at.sample;
  return {select(by_angle, at.sample.direction, sample.direction),
          hn::IfThenElse(by_angle, at.sample.distance, sample.distance),
          hn::IfThenElse(by_angle, at.sample.form, sample.form)};
}

/// A point to sample, with the shape's numbers from find_places.
struct SampleQuery {
  const LightConstants& light;
  const ReceiverLanes& receiver;
  const Vectors& middle;  ///< of the light, relative to the receiver
  const LightArcs& arc;
  const LightPointBatch& places;
  std::size_t i;

  [[nodiscard]] HWY_INLINE DiskPlaces on_disk() const {
    return concentric(centred(&places.u[i]), centred(&places.v[i]));
  }
};

HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::point>, const SampleQuery& q) {
  return point_sample(q.light, q.receiver, q.middle);
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::distant>, const SampleQuery& q) {
  const Vectors direction = all_lanes(q.light.towards);
  return {direction, hn::Inf(FloatTag()), cosine_above(direction, q.receiver)};
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::ball>, const SampleQuery& q) {
  return ball_sample(q.light, q.receiver, q.middle, q.on_disk());
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::sun>, const SampleQuery& q) {
  return cone_sample(q.receiver, all_lanes(q.light.towards), all_lanes(q.light.one_less_cosine),
                     q.on_disk());
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::segment>, const SampleQuery& q) {
  return segment_sample(q.light, q.receiver, q.middle, q.arc, q.i);
}
/// `arc`: from capsule_places.
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::capsule>, const SampleQuery& q) {
  Offset at = towards_point(
      {loaded(q.arc.first, q.i), loaded(q.arc.second, q.i), loaded(q.arc.third, q.i)});
  at.sample.form = loaded(q.arc.fourth, q.i);
  return at.sample;
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::rectangle>, const SampleQuery& q) {
  return rectangle_sample(q.light, q.receiver, q.middle, q.arc, q.places, q.i);
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::polygon>, const SampleQuery& q) {
  return area_sample(q.light, q.receiver,
                     q.middle + scaled(loaded(q.arc.first, q.i), all_lanes(q.light.u_axis)) +
                         scaled(loaded(q.arc.second, q.i), all_lanes(q.light.v_axis)));
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::disk>, const SampleQuery& q) {
  const DiskPlaces p = q.on_disk();
  return area_sample(
      q.light, q.receiver,
      q.middle + scaled(p.x, all_lanes(q.light.half_u)) + scaled(p.y, all_lanes(q.light.half_v)));
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
