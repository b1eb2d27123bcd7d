// Lanes of numbers and of vectors, with loads and stores. Included once for each instruction set.
#if defined(ASOS_KERNELS_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LANES_H
#undef ASOS_KERNELS_LANES_H
#else
#define ASOS_KERNELS_LANES_H
#endif

#include "renderer/kernels/shading_points.h"
#include "renderer/kernels/simd_math.h"

#include <cstddef>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

using FloatTag = hn::ScalableTag<float>;
using Lane = LaneOf<FloatTag>;
using LaneMask = MaskOf<FloatTag>;
using Vectors = Vec3<Lane>;
constexpr float infinity = std::numeric_limits<float>::infinity();

HWY_INLINE Lane loaded(const ShadingPoints::Floats& from, std::size_t i) {
  return Lane::loaded(&from[i]);
}
HWY_INLINE Vectors loaded(const ShadingPoints::Vectors& from, std::size_t i) {
  return {loaded(from.x, i), loaded(from.y, i), loaded(from.z, i)};
}
HWY_INLINE void store(Lane value, ShadingPoints::Floats& to, std::size_t i) {
  value.store(&to[i]);
}
HWY_INLINE void store(const Vectors& value, ShadingPoints::Vectors& to, std::size_t i) {
  store(value.x, to.x, i);
  store(value.y, to.y, i);
  store(value.z, to.z, i);
}

using DoubleTag = hn::ScalableTag<double>;
using DoubleLane = LaneOf<DoubleTag>;
using DoubleVectors = Vec3<DoubleLane>;

HWY_INLINE DoubleLane doubles(const float* from) {
  const hn::Rebind<float, DoubleTag> df;
  return hn::PromoteTo(DoubleTag(), hn::LoadU(df, from));
}
HWY_INLINE DoubleVectors doubles(const ShadingPoints::Vectors& from, std::size_t i) {
  return {doubles(&from.x[i]), doubles(&from.y[i]), doubles(&from.z[i])};
}
HWY_INLINE void store_floats(DoubleLane v, float* to) {
  const hn::Rebind<float, DoubleTag> df;
  hn::StoreU(hn::DemoteTo(df, v.raw), df, to);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
