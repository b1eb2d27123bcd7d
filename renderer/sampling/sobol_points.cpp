#include "renderer/sampling/sobol_points.h"

#include "renderer/sampling/random.h"

#include <array>
#include <cstddef>

namespace asos {
namespace {

constexpr int digits = 32;
using DirectionNumbers = std::array<std::uint32_t, digits>;  // by digit of the index

/// The primitive polynomial x^degree + a_1 x^(degree-1) + ... + 1 over the integers modulo 2, with
/// the a_i as the bits of `inner`, a_1 first; and the first direction integers m_1 to m_degree.
struct Polynomial {
  std::size_t degree;
  std::uint32_t inner;
  std::array<std::uint32_t, 3> first;
};

constexpr Polynomial second_dimension{1, 0, {1}};
constexpr Polynomial third_dimension{2, 1, {1, 3}};
constexpr Polynomial fourth_dimension{3, 1, {1, 3, 1}};

/// Van der Corput's sequence: the index with its digits mirrored.
constexpr DirectionNumbers mirrored() {
  DirectionNumbers numbers{};
  for (std::size_t k = 0; k < digits; ++k) numbers[k] = 1u << (digits - 1 - k);
  return numbers;
}

/// Sobol's recurrence: m_k = 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ ... ^ 2^s m_(k-s) ^ m_(k-s).
constexpr DirectionNumbers generated(const Polynomial& p) {
  DirectionNumbers m{};
  for (std::size_t k = 0; k < digits; ++k) {
    if (k < p.degree) {
      m[k] = p.first[k];
      continue;
    }
    m[k] = m[k - p.degree] ^ (m[k - p.degree] << p.degree);
    for (std::size_t i = 1; i < p.degree; ++i) {
      if ((p.inner >> (p.degree - 1 - i)) & 1u) m[k] ^= m[k - i] << i;
    }
  }
  for (std::size_t k = 0; k < digits; ++k) m[k] <<= digits - 1 - k;
  return m;
}

constexpr std::array<DirectionNumbers, sobol_dimensions> directions = {
    mirrored(), generated(second_dimension), generated(third_dimension),
    generated(fourth_dimension)};

constexpr std::uint32_t sum_of_directions(const DirectionNumbers& numbers, std::uint32_t index) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; index != 0; ++k, index >>= 1) {
    if (index & 1u) bits ^= numbers[k];
  }
  return bits;
}

constexpr std::array<SobolByteTable, 4> byte_tables(const DirectionNumbers& numbers) {
  std::array<SobolByteTable, 4> tables{};
  for (std::uint32_t k = 0; k < tables.size(); ++k) {
    for (std::uint32_t i = 0; i < tables[k].size(); ++i)
      tables[k][i] = mirrored_digits(sum_of_directions(numbers, i << (8 * k)));
  }
  return tables;
}

// Returns the seed of a scrambled dimension. Each number of a stream has its own seeds for the last
// two.
std::uint64_t seed_of(std::uint64_t key, std::uint32_t number, SobolDimension dimension) {
  static_assert(sobol_dimensions == 4);
  return mix_bits(key + ((std::uint64_t{number} << 2) | static_cast<std::uint64_t>(dimension)));
}

// Returns the seed of the order of a stream's points.
std::uint64_t seed_of_order(std::uint64_t key, std::uint32_t number) {
  return seed_of(key, number, SobolDimension::pixel_x);
}

// owen_scramble of a fraction with mirrored digits: the hash of Laine and Karras 2011, "Stratified
// sampling for stochastic transparency", in the form of Vegdahl 2021, "Building a better LK hash",
// with a 64-bit seed. With mirrored digits, sums and products carry from a digit to later ones
// only.
std::uint32_t scramble_mirrored_digits(std::uint32_t x, std::uint64_t seed) {
  x ^= x * 0x3d20adeau;
  x += static_cast<std::uint32_t>(seed);
  x *= static_cast<std::uint32_t>(seed >> 32) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return mirrored_digits(x);
}

double scrambled(SobolDimension dimension, std::uint32_t index, std::uint64_t seed) {
  constexpr double scale = 1.0 / 4294967296.0;
  return scale * scramble_mirrored_digits(mirrored_sobol_bits(dimension, index), seed);
}

}  // namespace

constexpr std::array<std::array<SobolByteTable, 4>, sobol_dimensions> mirrored_sobol_bytes{
    byte_tables(directions[0]), byte_tables(directions[1]), byte_tables(directions[2]),
    byte_tables(directions[3])};

std::uint32_t sobol_bits(SobolDimension dimension, std::uint32_t index) {
  return mirrored_digits(mirrored_sobol_bits(dimension, index));
}

std::uint32_t owen_scramble(std::uint32_t bits, std::uint64_t seed) {
  return scramble_mirrored_digits(mirrored_digits(bits), seed);
}
SobolPixel::SobolPixel(int x, int y, std::uint32_t seed)
    : key_(pixel_random(x, y, seed)),
      seed_x_(seed_of(key_, 0, SobolDimension::pixel_x)),
      seed_y_(seed_of(key_, 0, SobolDimension::pixel_y)) {}

glm::dvec2 SobolPixel::pixel(std::uint32_t index) const {
  return {scrambled(SobolDimension::pixel_x, index, seed_x_),
          scrambled(SobolDimension::pixel_y, index, seed_y_)};
}

glm::dvec2 SobolPixel::light(std::uint32_t index, std::uint32_t light) const {
  const Seeds seeds = light_seeds(light);
  return {scrambled(SobolDimension::light_u, index, seeds.u),
          scrambled(SobolDimension::light_v, index, seeds.v)};
}

SobolPixel::Seeds SobolPixel::light_seeds(std::uint32_t light) const {
  return {seed_of(key_, light, SobolDimension::light_u),
          seed_of(key_, light, SobolDimension::light_v)};
}

glm::dvec2 SobolPixel::lobe(std::uint32_t index, SampleStream stream, std::uint32_t k) const {
  const std::uint32_t number = number_of(stream, k);
  return light(owen_scramble(index, seed_of_order(key_, number)), number);
}

glm::dvec2 SobolPixel::lens(std::uint32_t index) const {
  return light(index, number_of(SampleStream::lens));
}

double SobolPixel::time(std::uint32_t index, bool beside_lens) const {
  const std::uint64_t order = seed_of_order(key_, number_of(SampleStream::time_order));
  return light(beside_lens ? owen_scramble(index, order) : index, number_of(SampleStream::time)).x;
}

std::uint32_t SobolPixel::shuffled(std::uint32_t index) const {
  return owen_scramble(index, seed_of_order(key_, number_of(SampleStream::light_order)));
}

}  // namespace asos
