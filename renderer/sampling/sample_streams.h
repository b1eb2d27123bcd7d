#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

// The uses of random numbers. Uses whose values are multiplied must be independent, so they have
// ranges of numbers that do not overlap.

/// The dimensions of Sobol's sequence that a sample has. A place on a light, on the lens or in a
/// lobe has the last two, in one of the streams below.
enum class SobolDimension : std::uint8_t { pixel_x, pixel_y, light_u, light_v };
inline constexpr std::size_t sobol_dimensions = 4;

/// Streams of a sample. Each number of a stream scrambles light_u and light_v by its own seeds. A
/// value is the stream's first number.
enum class SampleStream : std::uint32_t {
  lights = 0,              ///< places on lights, one number a light
  highlights = 0x3000,     ///< directions of the lobe towards lights, the same for all lights
  grid_lobes = 0x4000,     ///< the streams from `reflections` to `roulette`, for GridSampler
  reflections = 1u << 31,  ///< directions of blurred reflections, one number a bounce
  light_choice = reflections + 0x1000,   ///< selection of lights
  sky = reflections + 0x1001,            ///< directions to the sky
  sky_of_bounce = reflections + 0x1002,  ///< the same from a surface that another ray hit
  roulette = reflections + 0x2000,       ///< Russian roulette of reflections, one number a bounce
  lens = 3u << 30,                       ///< places on the lens
  light_order = lens + 1,  ///< order of the points of `lights` where lens or time use theirs
  time = lens + 2,         ///< times while the shutter is open
  time_order = lens + 3,   ///< order of their points where the lens uses theirs
};

/// Streams of GridSampler; `pixel` has one number a sample.
enum class GridStream : std::uint32_t {
  pixel = 0,
  time = 1u << 29,
  lens = 1u << 30,
  lights = 1u << 31,  ///< number of a SampleStream times grid_light_step
};
inline constexpr std::uint32_t grid_light_step = 0x10001;

/// A stream and how many numbers it has.
struct StreamRange {
  std::uint32_t first;
  std::uint32_t count;
};
template <typename Stream>
constexpr StreamRange range_of(Stream stream, std::uint32_t count = 1) {
  return {static_cast<std::uint32_t>(stream), count};
}
/// Returns number `k` of a stream.
template <typename Stream>
constexpr std::uint32_t number_of(Stream stream, std::uint32_t k = 0) {
  return static_cast<std::uint32_t>(stream) + k;
}

inline constexpr std::uint32_t most_bounce_streams = 0x1000;
inline constexpr std::uint32_t grid_lobe_streams =
    number_of(SampleStream::roulette, most_bounce_streams) - number_of(SampleStream::reflections);

/// Returns whether no two ranges share a number, for ranges in ascending order.
template <std::size_t n>
constexpr bool disjoint(const std::array<StreamRange, n>& ranges) {
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const std::uint64_t end = std::uint64_t{ranges[i].first} + ranges[i].count;
    if (end > ranges[i + 1].first) return false;
  }
  return true;
}
// A scene with more lights than `highlights` is rendered, but one light's places are those of the
// lobe.
static_assert(disjoint(std::array{
    range_of(SampleStream::lights, number_of(SampleStream::highlights)),
    range_of(SampleStream::highlights), range_of(SampleStream::grid_lobes, grid_lobe_streams),
    range_of(SampleStream::reflections, most_bounce_streams), range_of(SampleStream::light_choice),
    range_of(SampleStream::sky), range_of(SampleStream::sky_of_bounce),
    range_of(SampleStream::roulette, most_bounce_streams), range_of(SampleStream::lens),
    range_of(SampleStream::light_order), range_of(SampleStream::time),
    range_of(SampleStream::time_order)}));
static_assert(disjoint(std::array{
    range_of(GridStream::pixel, 1u << 20), range_of(GridStream::time), range_of(GridStream::lens),
    range_of(GridStream::lights,
             grid_light_step* number_of(SampleStream::grid_lobes, grid_lobe_streams))}));

}  // namespace asos
