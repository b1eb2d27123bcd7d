#include "renderer/samples/sample_block.h"
#include "renderer/sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace asos {
namespace {

// Returns element i of a permutation of 0 .. length - 1 without a table (Kensler 2013, "Correlated
// multi-jittered sampling", section 2). It applies invertible steps on the next power of two,
// repeated until the result is in range.
std::uint32_t permuted(std::uint32_t i, std::uint32_t length, std::uint32_t seed) {
  std::uint32_t mask = length - 1;
  for (const int shift : {1, 2, 4, 8, 16}) mask |= mask >> shift;
  do {
    i ^= seed;
    i *= 0xe170893d;
    i ^= seed >> 16;
    i ^= (i & mask) >> 4;
    i ^= seed >> 8;
    i *= 0x0929eb3f;
    i ^= seed >> 23;
    i ^= (i & mask) >> 1;
    i *= 1 | seed >> 27;
    i *= 0x6935fa69;
    i ^= (i & mask) >> 11;
    i *= 0x74dcb303;
    i ^= (i & mask) >> 2;
    i *= 0x9e501cc3;
    i ^= (i & mask) >> 2;
    i *= 0xc860a3df;
    i &= mask;
    i ^= i >> 5;
  } while (i >= length);
  return (i + seed) % length;
}

// Returns a step of about the golden section of the number of strata and coprime to it. Steps of
// this length visit each stratum once, and successive strata are far apart.
int step_of(int strata) {
  constexpr double golden_section = 0.61803398874989485;
  int step = std::max(1, static_cast<int>(std::lround(golden_section * strata)));
  while (std::gcd(step, strata) != 1) ++step;
  return step;
}

}  // namespace

GridSampler::GridSampler(int n, bool jittered)
    : n_(n), step_(step_of(n * n)), jittered_(jittered) {}

PixelPoint GridSampler::in_pixel() const {
  RandomPair r{0.5, 0.5};
  if (jittered_) r = unit_pair(pixel_random(x_, y_, static_cast<std::uint32_t>(index_)));
  return {(index_ % n_ + r.u) / n_, (index_ / n_ + r.v) / n_};
}

glm::dvec2 GridSampler::on_light(std::uint32_t light) const {
  return in_strata(number_of(GridStream::lights, light * grid_light_step));
}

glm::dvec2 GridSampler::on_lens() const {
  return in_strata(number_of(GridStream::lens));
}

double GridSampler::in_time() const {
  const Stratum found = stratum(number_of(GridStream::time));
  return (found.cell + found.place.u) / (n_ * n_);
}

glm::dvec2 GridSampler::in_strata(std::uint32_t stream) const {
  const auto [cell, r] = stratum(stream);
  return {(cell % n_ + r.u) / n_, (cell / n_ + r.v) / n_};
}

GridSampler::Stratum GridSampler::stratum(std::uint32_t stream) const {
  const auto seed = static_cast<std::uint32_t>(pixel_random(x_, y_, stream) >> 32);
  const auto cells = static_cast<std::uint32_t>(n_ * n_);
  const auto cell = static_cast<int>(permuted(static_cast<std::uint32_t>(index_), cells, seed));
  RandomPair r{0.5, 0.5};
  if (jittered_) {
    r = unit_pair(mix_bits(pixel_random(x_, y_, stream) ^
                           (0x100000000ULL + static_cast<std::uint64_t>(index_))));
  }
  return {cell, r};
}

}  // namespace asos
