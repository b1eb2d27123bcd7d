// Arc functions for sampling by angles, in double precision: solid angles and angles of distant
// lights are differences of large ones. Included once for each instruction set.
#if defined(ASOS_KERNELS_ARC_PLACES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_ARC_PLACES_H
#undef ASOS_KERNELS_ARC_PLACES_H
#else
#define ASOS_KERNELS_ARC_PLACES_H
#endif

#include "renderer/kernels/lanes.h"
#include "renderer/kernels/light_kernel.h"
#include "renderer/lights/kinds/shared.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// Converts 32-bit binary fractions to 0 to 1, exactly.
HWY_INLINE DoubleLane fractions(const std::uint32_t* from) {
  const hn::Rebind<std::int32_t, DoubleTag> di;
  const auto bits = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(from));
  const auto centred = hn::Xor(bits, hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  return DoubleLane(hn::PromoteTo(DoubleTag(), centred)) * (1.0 / 4294967296.0) + 0.5;
}
HWY_INLINE DoubleVectors to_middle(const ShadingPoints& points, std::size_t i, glm::dvec3 middle) {
  return DoubleVectors(middle) - doubles(points.position, i);
}

struct DoubleReceivers {
  DoubleVectors geometric, normal;
};

/// Finds the numbers of a shape with Sampling::solid_angle that are the same for all samples.
template <LightShape shape>
void find_arcs(const ShadingPoints& points, const PreparedLight& light, LightArcs& found) {
  if (found.known) return;
  found.known = true;
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const DoubleReceivers receiver{doubles(points.geometric, i), doubles(points.normal, i)};
    const auto arcs =
        SharedGeometry<shape>::arcs(light, receiver, to_middle(points, i, light.position));
    store_floats(arcs.solid_angle, &found.first[i]);
    store_floats(arcs.y0, &found.third[i]);
    store_floats(arcs.y1, &found.fourth[i]);
    arcs.solid_angle.store(&found.solid_angle[i]);
    arcs.sine.store(&found.sine[i]);
    arcs.cosine.store(&found.cosine[i]);
    arcs.normal_0.store(&found.normal_0[i]);
    arcs.normal_2.store(&found.normal_2[i]);
  }
}

template <LightShape shape>
void find_slopes(const ShadingPoints& points, const LightPointBatch& places, LightArcs& found) {
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const auto of = [&](const LightArcs::Doubles& from)
                        HWY_ATTR { return DoubleLane::loaded(&from[i]); };
    const typename SharedGeometry<shape>::template Arcs<DoubleLane> arcs{0.0,
                                                                         0.0,
                                                                         of(found.solid_angle),
                                                                         of(found.sine),
                                                                         of(found.cosine),
                                                                         of(found.normal_0),
                                                                         of(found.normal_2)};
    if (none(arcs.solid_angle > 0.0)) continue;
    store_floats(SharedGeometry<shape>::slope2(arcs, fractions(&places.u[i])), &found.second[i]);
  }
}

/// Finds the numbers of a shape's samples at each point; see SharedGeometry.
template <LightShape shape>
void find_places(const ShadingPoints& points, const PreparedLight& light,
                 const LightPointBatch& places, LightArcs& found) {
  constexpr Sampling by = traits_of(shape).sampling;
  if constexpr (by == Sampling::solid_angle) {
    find_arcs<shape>(points, light, found);
    find_slopes<shape>(points, places, found);
  }
  if constexpr (by == Sampling::lanes || by == Sampling::lanes_or_scalar) {
    for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
      const DoubleReceivers receiver{doubles(points.geometric, i), doubles(points.normal, i)};
      const auto numbers =
          SharedGeometry<shape>::numbers(light, receiver, to_middle(points, i, light.position),
                                         fractions(&places.u[i]), fractions(&places.v[i]));
      store_floats(numbers.first, &found.first[i]);
      store_floats(numbers.second, &found.second[i]);
      store_floats(numbers.third, &found.third[i]);
      store_floats(numbers.fourth, &found.fourth[i]);
    }
  }
  constexpr double scale = 1.0 / 4294967296.0;
  if constexpr (by == Sampling::lanes_or_scalar) {
    for (std::size_t i = 0; i < points.count; ++i) {
      if (!(found.fourth[i] < 0.0f)) continue;
      const Receiver receiver{points.position.at(i), points.normal.at(i), points.geometric.at(i)};
      const glm::vec4 n = sample_numbers(light, receiver, scale * places.u[i], scale * places.v[i]);
      found.first[i] = n.x, found.second[i] = n.y, found.third[i] = n.z, found.fourth[i] = n.w;
    }
  }
  if constexpr (by == Sampling::rows) {
    for (std::size_t i = 0; i < points.count; ++i) {
      const glm::vec2 p(light.rows.point(scale * places.u[i], scale * places.v[i]));
      found.first[i] = p.x, found.second[i] = p.y;
    }
  }
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
