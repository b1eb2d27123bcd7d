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

/// As scramble_mirrored_digits.
HWY_INLINE Bits scrambled_lanes(Bits x, Bits low, Bits high) {
  const Tag d;
  x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x3d20adeau)));
  x = hn::Add(x, low);
  x = hn::Mul(x, hn::Or(high, hn::Set(d, 1u)));
  x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x05526c56u)));
  x = hn::Xor(x, hn::Mul(x, hn::Set(d, 0x53a22864u)));
  return mirrored_lanes(x);
}

void scramble(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
              std::uint32_t* scrambled) {
  const Tag d;
  const auto low = hn::Set(d, static_cast<std::uint32_t>(seed));
  const auto high = hn::Set(d, static_cast<std::uint32_t>(seed >> 32));
  for (std::size_t i = 0; i < mirrored.size(); i += hn::Lanes(d))
    hn::StoreU(scrambled_lanes(hn::LoadU(d, &mirrored[i]), low, high), d, scrambled + i);
}

void scramble_each(const SeededFractions& of, std::size_t count, std::uint32_t* scrambled) {
  const Tag d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto mirrored = hn::LoadU(d, &of.mirrored[i]);
    const auto low = hn::LoadU(d, &of.low[i]), high = hn::LoadU(d, &of.high[i]);
    hn::StoreU(scrambled_lanes(mirrored, low, high), d, scrambled + i);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(scramble);
HWY_EXPORT(scramble_each);

void scramble_mirrored(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
                       std::uint32_t* scrambled) {
  HWY_DYNAMIC_DISPATCH(scramble)(mirrored, seed, scrambled);
}

void scramble_mirrored(const SeededFractions& fractions, std::size_t count,
                       std::uint32_t* scrambled) {
  HWY_DYNAMIC_DISPATCH(scramble_each)(fractions, count, scrambled);
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

void SobolBatch::on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                          LightPointBatch& places) const {
  SeededFractions u, v;
  SobolPixel::Seeds seeds{};
  std::size_t next_run = 0;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const std::size_t before = next_run;
    while (next_run < runs_.size() && runs_[next_run].first <= of[k]) ++next_run;
    if (next_run > before) seeds = runs_[next_run - 1].pixel.light_seeds(light);
    u.set(k, u_[of[k]], seeds.u);
    v.set(k, v_[of[k]], seeds.v);
  }
  scramble_mirrored(u, of.size(), places.u.data());
  scramble_mirrored(v, of.size(), places.v.data());
}

}  // namespace asos
#endif
