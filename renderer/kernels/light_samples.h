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

HWY_INLINE ReceiverLanes receivers(const ShadingPoints& points, std::size_t i) {
  return {loaded(points.position, i), loaded(points.geometric, i), loaded(points.normal, i)};
}
HWY_INLINE Vectors to_middle(const LightConstants& light, const ReceiverLanes& receiver) {
  return light.position - receiver.position + light.position_rest;
}

using SampleLanes = SampleOf<Vectors>;
HWY_INLINE SampleLanes selected(LaneMask mask, const SampleLanes& yes, const SampleLanes& no) {
  return {selected(mask, yes.direction, no.direction), selected(mask, yes.distance, no.distance),
          selected(mask, yes.form, no.form)};
}

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

template <LightShape shape>
inline constexpr bool by_solid_angle = traits_of(shape).sampling == Sampling::solid_angle;

/// A point to sample, with the shape's numbers from find_places.
struct SampleQuery {
  const LightConstants& light;
  const ReceiverLanes& receiver;
  const Vectors& middle;  ///< of the light, relative to the receiver
  const LightArcs& arc;
  const LightPointBatch& places;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Lane u() const { return centred(&places.u[i]); }
  [[nodiscard]] HWY_INLINE Lane v() const { return centred(&places.v[i]); }
  [[nodiscard]] HWY_INLINE DiskPlaces on_disk() const { return concentric(u(), v()); }
  [[nodiscard]] static HWY_INLINE Vectors vector(const Vectors& v) { return v; }
  [[nodiscard]] HWY_INLINE Numbers<Lane> numbers() const {
    return {loaded(arc.first, i), loaded(arc.second, i), loaded(arc.third, i),
            loaded(arc.fourth, i)};
  }
};

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
