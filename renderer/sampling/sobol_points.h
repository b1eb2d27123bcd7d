#pragma once

#include "renderer/sampling/sample_streams.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// Returns a dimension of point `index` of Sobol's sequence, as a 32-bit binary fraction
/// (Sobol 1967, with the direction numbers of Joe and Kuo 2008, "Constructing Sobol sequences with
/// better two-dimensional projections", table new-joe-kuo-6.21201). Points are in the order of
/// their indices, not of the Gray code.
[[nodiscard]] std::uint32_t sobol_bits(SobolDimension dimension, std::uint32_t index);

/// Owen's nested uniform scrambling of a binary fraction: a hash of the seed and all digits before
/// it decides whether a digit is flipped, so that nets remain nets (Owen 1995, "Randomly permuted
/// (t,m,s)-nets and (t,s)-sequences"; Burley 2020, "Practical hash-based Owen scrambling").
[[nodiscard]] std::uint32_t owen_scramble(std::uint32_t bits, std::uint64_t seed);

/// Returns the digits in reverse order.
[[nodiscard]] constexpr std::uint32_t mirrored_digits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// mirrored_digits of sobol_bits by dimension, for the values of each byte of an index, the lowest
/// first. The value for a whole index is the exclusive-or of those of its bytes.
using SobolByteTable = std::array<std::uint32_t, 256>;
extern const std::array<std::array<SobolByteTable, 4>, sobol_dimensions> mirrored_sobol_bytes;

/// Returns mirrored_digits of sobol_bits, the input of owen_scramble.
[[nodiscard]] inline std::uint32_t mirrored_sobol_bits(SobolDimension dimension,
                                                       std::uint32_t index) {
  const auto& bytes = mirrored_sobol_bytes[static_cast<std::size_t>(dimension)];
  std::uint32_t bits = bytes[0][index & 255u];
  for (std::size_t k = 1; (index >>= 8) != 0; ++k) bits ^= bytes[k][index & 255u];
  return bits;
}

/// The sample points of one pixel: Sobol's first four dimensions, each with its own scrambling.
/// They depend only on the pixel, the seed of the run and the sample's index.
///
/// Points 0 to 2^m - 1, and every later 2^m that start at a multiple of 2^m, form these nets: a (0,
/// m, 2)-net on the pixel, a (2, m, 2)-net on each light, and up to m = 10 a (3, m, 4)-net on both
/// together. Each point is uniform by itself, and independent between pixels, seeds and lights.
///
/// All lights use light_u and light_v of the same point, with different scrambling. Burley pads
/// with points in shuffled order, which a product of functions of different lights would need. But
/// the contribution of several lights is a sum, and shuffling would destroy each light's joint
/// stratification with the pixel. Lobes are padded with points in shuffled order, as Burley does:
/// the surface in a reflection is lit by the same lights, and a product needs all four dimensions.
class SobolPixel {
 public:
  SobolPixel(int x, int y, std::uint32_t seed);

  /// Returns the place of sample `index` in the pixel, each coordinate in [0, 1).
  [[nodiscard]] glm::dvec2 pixel(std::uint32_t index) const;

  /// Returns the place of sample `index` on light number `light`, or in that number of another
  /// stream, each coordinate in [0, 1).
  [[nodiscard]] glm::dvec2 light(std::uint32_t index, std::uint32_t light) const;

  /// Returns the place of sample `index` on the camera's lens, each coordinate in [0, 1). It has
  /// a light's dimensions, so that pixel and lens together are a net. Lights then use `shuffled`
  /// indices.
  [[nodiscard]] glm::dvec2 lens(std::uint32_t index) const;
  /// Returns the time of sample `index` while the shutter is open, in [0, 1). It has
  /// light_u, so that pixel and time together are a net. With `beside_lens`, the lens has that
  /// dimension, and the time uses another order of points.
  [[nodiscard]] double time(std::uint32_t index, bool beside_lens) const;
  /// Returns the index in another order of points, for samples that share dimensions with lens or
  /// time. Aligned runs of 2^m indices stay such runs.
  [[nodiscard]] std::uint32_t shuffled(std::uint32_t index) const;

  /// The scrambling seeds, for callers that scramble many places. `pixel` is owen_scramble of
  /// sobol_bits(pixel_x, index) with `u` and of sobol_bits(pixel_y, index) with `v`; `light` is the
  /// same for light_u and light_v.
  struct Seeds {
    std::uint64_t u, v;
  };
  [[nodiscard]] Seeds pixel_seeds() const { return {seed_x_, seed_y_}; }
  [[nodiscard]] Seeds light_seeds(std::uint32_t light) const;

  /// Returns the place of sample `index` in number `k` of a stream with an order of its own, each
  /// coordinate in [0, 1). The pixel's first 2^m samples are a net there, too.
  [[nodiscard]] glm::dvec2 lobe(std::uint32_t index, SampleStream stream,
                                std::uint32_t k = 0) const;

 private:
  std::uint64_t key_;
  std::uint64_t seed_x_;
  std::uint64_t seed_y_;
};

}  // namespace asos
