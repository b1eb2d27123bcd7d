#include "renderer/kernels/sobol_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/sobol_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<std::uint32_t>;
using Bits = hn::Vec<Tag>;

template <int by>
HWY_INLINE Bits swapped(Bits x, std::uint32_t low) {
  const auto mask = hn::Set(Tag(), low);
  return hn::Or(hn::And(hn::ShiftRight<by>(x), mask), hn::ShiftLeft<by>(hn::And(x, mask)));
}

HWY_INLINE Bits mirrored_lanes(Bits x) {
  x = swapped<1>(x, 0x55555555u);
  x = swapped<2>(x, 0x33333333u);
  x = swapped<4>(x, 0x0f0f0f0fu);
  x = swapped<8>(x, 0x00ff00ffu);
  return hn::Or(hn::ShiftRight<16>(x), hn::ShiftLeft<16>(x));
}

void scramble(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
              std::uint32_t* scrambled) {
  const Tag d;
  const auto added = hn::Set(d, static_cast<std::uint32_t>(seed));
  const auto factor = hn::Set(d, static_cast<std::uint32_t>(seed >> 32) | 1u);
  for (std::size_t i = 0; i < mirrored.size(); i += hn::Lanes(d)) {
    auto x = hn::LoadU(d, &mirrored[i]);
    x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x3d20adeau)));
    x = hn::Add(x, added);
    x = hn::Mul(x, factor);
    x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x05526c56u)));
    x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x53a22864u)));
    hn::StoreU(mirrored_lanes(x), d, scrambled + i);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(scramble);

void scramble_mirrored(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
                       std::uint32_t* scrambled) {
  HWY_DYNAMIC_DISPATCH(scramble)(mirrored, seed, scrambled);
}

void SobolPixelSampler::take_turn(const SobolPixel& pixel, std::uint32_t turn) {
  turn_ = turn;
  std::array<std::uint32_t, per_turn> u, v;
  for (std::uint32_t i = 0; i < per_turn; ++i) {
    u[i] = mirrored_sobol_bits(SobolDimension::pixel_x, turn * per_turn + i);
    v[i] = mirrored_sobol_bits(SobolDimension::pixel_y, turn * per_turn + i);
  }
  const SobolPixel::Seeds seeds = pixel.pixel_seeds();
  scramble_mirrored(u, seeds.u, u_.data());
  scramble_mirrored(v, seeds.v, v_.data());
}

void SobolBatch::clear() {
  count_ = 0;
  runs_.clear();
}

void SobolBatch::add(const SobolPixel& pixel, std::uint32_t index) {
  runs_.push_back({pixel, count_});
  add(index);
}

void SobolBatch::on_light(std::uint32_t light, LightPointBatch& places) const {
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    // Each run may write beyond its end; the next run overwrites that.
    const std::size_t first = runs_[r].first;
    const std::size_t length = (r + 1 < runs_.size() ? runs_[r + 1].first : count_) - first;
    const SobolPixel::Seeds seeds = runs_[r].pixel.light_seeds(light);
    scramble_mirrored(std::span(u_).subspan(first, length), seeds.u, &places.u[first]);
    scramble_mirrored(std::span(v_).subspan(first, length), seeds.v, &places.v[first]);
  }
}

}  // namespace asos
#endif
