// Samples on a light, as sample_light, with one point per lane. Included once for each instruction
// set.
#if defined(ASOS_KERNELS_LIGHT_SAMPLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LIGHT_SAMPLES_H
#undef ASOS_KERNELS_LIGHT_SAMPLES_H
#else
#define ASOS_KERNELS_LIGHT_SAMPLES_H
#endif

#include "renderer/kernels/arc_places.h"
#include "renderer/lights/kinds/shared.h"

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
struct ReceiverLanes {
  Vectors position, geometric, normal;
};

/// As LightSample. The light's power times `form` is the irradiance.
struct SampleLanes {
  Vectors direction;
  Lane distance;
  Lane form;
};

/// Maps 0 to 1 onto -1 to 1, with one rounding.
HWY_INLINE Lane centred(const std::uint32_t* from) {
  const hn::RebindToSigned<FloatTag> di;
  const auto bits = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(from));
  const auto moved = hn::Xor(bits, hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  return Lane(hn::ConvertTo(FloatTag(), moved)) * (1.0f / 2147483648.0f);
}

struct DiskPlaces {
  Lane x, y;
};
/// Maps the square from -1 to 1 onto the unit disk. Preserves areas and neighbourhoods (Shirley and
/// Chiu 1997).
HWY_INLINE DiskPlaces concentric(Lane a, Lane b) {
  const auto wide = abs(a) > abs(b);
  const auto r = selected(wide, a, b);
  const auto other = selected(wide, b, a);
  const auto none = r == 0.0f;
  const auto quotient = other / selected(none, 1.0f, r);
  const auto turn = sin_cos_of_eighth(0.25f * std::numbers::pi_v<float> * quotient);
  const auto near = r * turn.cos, far = r * turn.sin;
  return {selected(wide, near, far), selected(wide, far, near)};
}

/// Returns a unit vector perpendicular to a unit one, as any_perpendicular.
HWY_INLINE Vectors any_perpendicular(const Vectors& axis) {
  const auto by_x = abs(axis.x) < 0.6f;
  const Vectors across{selected(by_x, 0.0f, axis.z), where(by_x, -axis.z),
                       selected(by_x, axis.y, -axis.x)};
  return 1.0f / sqrt(dot(across, across)) * across;
}

HWY_INLINE Lane cosine_above(const Vectors& direction, const ReceiverLanes& receiver) {
  const auto above = dot(direction, receiver.geometric) > 0.0f;
  return where(above, max(dot(direction, receiver.normal), 0.0f));
}

/// A point of the light at `offset` from the receiver; its form factor is set later. At the
/// receiver itself it has no direction.
struct Offset {
  SampleLanes sample;
  Lane nearness;  ///< 1 / distance
  LaneMask apart;
};
HWY_INLINE Offset towards_point(const Vectors& offset) {
  const auto distance = sqrt(dot(offset, offset));
  const auto apart = distance > 0.0f;
  const auto nearness = 1.0f / selected(apart, distance, 1.0f);
  return {{nearness * offset, distance, 0.0f}, nearness, apart};
}

/// Returns a sample of a flat light that was chosen by area.
HWY_INLINE SampleLanes area_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                   const Vectors& offset) {
  Offset at = towards_point(offset);
  const auto below = dot(offset, light.towards);
  const auto height = light.two_sided ? abs(below) : -below;
  const auto faces = height > light.thickness;
  const auto seen = height * at.nearness;
  const auto facing = light.area * seen * cosine_above(at.sample.direction, receiver);
  at.sample.form = where(at.apart && faces, facing * at.nearness * at.nearness);
  return at.sample;
}

HWY_INLINE bool attenuates(const LightConstants& light) {
  return light.inverse_range != 0.0f || light.cone_scale != 0.0f;
}
/// As the function attenuation of a PreparedLight.
HWY_INLINE Lane attenuation(const LightConstants& light, const Vectors& middle, Lane distance,
                            Lane nearness) {
  const auto r = min(distance * light.inverse_range, 1.0f);
  const auto r2 = r * r;
  const auto by_range = 1.0f - r2 * r2;
  if (!(light.cone_scale > 0.0f)) return by_range;
  const auto cosine = dot(middle, light.towards) * nearness;
  const auto cone = clamp(cosine * light.cone_scale + light.cone_offset, 0.0f, 1.0f);
  return by_range * (cone * cone);
}

HWY_INLINE SampleLanes point_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                    const Vectors& middle) {
  Offset at = towards_point(middle);
  const auto cosine = cosine_above(at.sample.direction, receiver);
  auto form = cosine * at.nearness * at.nearness;
  if (attenuates(light)) form *= attenuation(light, middle, at.sample.distance, at.nearness);
  at.sample.form = where(at.apart, form);
  return at.sample;
}

/// Samples a direction within the cone about `axis`, uniformly by solid angle.
HWY_INLINE SampleLanes cone_sample(const ReceiverLanes& receiver, const Vectors& axis,
                                   Lane one_less_cosine, const DiskPlaces& p) {
  const auto radius2 = p.x * p.x + p.y * p.y;
  const auto drop = min(1.0f, radius2) * one_less_cosine;
  const auto stretch = sqrt((2.0f - drop) * one_less_cosine);
  const Vectors x_axis = any_perpendicular(axis);
  const Vectors direction =
      (1.0f - drop) * axis + stretch * p.x * x_axis + stretch * p.y * cross(axis, x_axis);
  const auto form =
      (2.0f * std::numbers::pi_v<float> * one_less_cosine) * cosine_above(direction, receiver);
  return {direction, infinity, form};
}

/// Samples a ball from the inside, where light arrives from all directions, by the cosine to the
/// receiver's normal.
HWY_INLINE SampleLanes inside_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                     const Vectors& middle, const DiskPlaces& p) {
  const Vectors x_axis = any_perpendicular(receiver.normal);
  const auto radius2 = p.x * p.x + p.y * p.y;
  const auto up = sqrt(max(0.0f, 1.0f - radius2));
  const Vectors direction =
      p.x * x_axis + p.y * cross(receiver.normal, x_axis) + up * receiver.normal;
  const auto along = dot(direction, middle);
  const auto power = max(0.0f, light.radius * light.radius - dot(middle, middle));
  const auto distance = along + sqrt(along * along + power);
  const auto above = dot(direction, receiver.geometric) > 0.0f;
  return {direction, distance, where(above, std::numbers::pi_v<float>)};
}

HWY_INLINE SampleLanes ball_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                   const Vectors& middle, const DiskPlaces& p) {
  const auto radius = light.radius;
  const Offset at = towards_point(middle);
  const auto sine = min(1.0f, radius * at.nearness);
  const auto cosine = sqrt((1.0f - sine) * (1.0f + sine));
  SampleLanes sample = cone_sample(receiver, at.sample.direction, sine * sine / (1.0f + cosine), p);
  // Choose the near side of the ball. At its rim the root rounds to either side of 0.
  const auto along = dot(sample.direction, middle);
  const Vectors beside = middle - along * sample.direction;
  const auto depth2 = radius * radius - dot(beside, beside);
  sample.distance = along - sqrt(max(0.0f, depth2));
  const auto inside = at.sample.distance <= radius;
  if (!none(inside)) {
    const SampleLanes within = inside_sample(light, receiver, middle, p);
    sample.direction = selected(inside, within.direction, sample.direction);
    sample.distance = selected(inside, within.distance, sample.distance);
    sample.form = selected(inside, within.form, sample.form);
  }
  if (attenuates(light)) {
    sample.form *= attenuation(light, middle, at.sample.distance, at.nearness);
  }
  return sample;
}

/// `arc`: from segment_places.
HWY_INLINE SampleLanes segment_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                      const Vectors& middle, const LightArcs& arc, std::size_t i) {
  const Vectors along = light.u_axis;
  const Vectors foot = middle - dot(middle, along) * along;
  Offset at = towards_point(foot + loaded(arc.first, i) * along);
  auto form = loaded(arc.second, i) * cosine_above(at.sample.direction, receiver);
  if (light.rule == LightRule::physical) form *= loaded(arc.third, i) * at.nearness;
  at.sample.form = where(at.apart, form * at.nearness * at.nearness);
  return at.sample;
}

/// Whether samples of a flat light are chosen by solid angle, which has a closed form.
template <LightShape shape>
inline constexpr bool by_solid_angle = shape == LightShape::rectangle;

/// `arc`: from rectangle_places.
HWY_INLINE SampleLanes rectangle_sample(const LightConstants& light, const ReceiverLanes& receiver,
                                        const Vectors& middle, const LightArcs& arc,
                                        const LightPointBatch& places, std::size_t i) {
  const auto v_centred = centred(&places.v[i]);
  const auto solid_angle = loaded(arc.first, i);
  const auto by_angle = solid_angle > 0.0f;
  SampleLanes sample;
  if (!all(by_angle)) {
    const auto u_centred = centred(&places.u[i]);
    sample =
        area_sample(light, receiver, middle + u_centred * light.half_u + v_centred * light.half_v);
    if (none(by_angle)) return sample;
  }
  const Vectors x_axis = light.u_axis, y_axis = light.v_axis;
  const Vectors z_axis = cross(x_axis, y_axis);
  const auto x_middle = dot(middle, x_axis);
  const auto z = dot(middle, z_axis);
  const auto slope2 = loaded(arc.second, i);
  const auto per_z = copysign(1.0f / sqrt(abs(slope2)), slope2);
  // At u = 0 and 1 the quotient rounds to either side of the rectangle's ends.
  const auto u_length = light.u_length;
  const auto x = clamp(abs(z) * per_z, x_middle - u_length, x_middle + u_length);
  const auto y0 = loaded(arc.third, i), y1 = loaded(arc.fourth, i);
  const auto d2 = x * x + z * z;
  const auto h0 = y0 / sqrt(d2 + y0 * y0);
  const auto h1 = y1 / sqrt(d2 + y1 * y1);
  constexpr float half = 0.5f;
  const auto v = v_centred * half + half;
  const auto h = h0 + v * (h1 - h0);
  const auto h_across = sqrt((1.0f - h) * (1.0f + h));
  const auto y = clamp(h * sqrt(d2) / h_across, y0, y1);
  Offset at = towards_point(x * x_axis + y * y_axis + z * z_axis);
  at.sample.form = solid_angle * cosine_above(at.sample.direction, receiver);
  if (all(by_angle)) return at.sample;
  return {selected(by_angle, at.sample.direction, sample.direction),
          selected(by_angle, at.sample.distance, sample.distance),
          selected(by_angle, at.sample.form, sample.form)};
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
  const Vectors direction = q.light.towards;
  return {direction, infinity, cosine_above(direction, q.receiver)};
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::ball>, const SampleQuery& q) {
  return ball_sample(q.light, q.receiver, q.middle, q.on_disk());
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::sun>, const SampleQuery& q) {
  return cone_sample(q.receiver, q.light.towards, q.light.one_less_cosine, q.on_disk());
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
                     q.middle + loaded(q.arc.first, q.i) * q.light.u_axis +
                         loaded(q.arc.second, q.i) * q.light.v_axis);
}
HWY_INLINE SampleLanes light_sample(ShapeTag<LightShape::disk>, const SampleQuery& q) {
  const DiskPlaces p = q.on_disk();
  return area_sample(q.light, q.receiver, q.middle + p.x * q.light.half_u + p.y * q.light.half_v);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
