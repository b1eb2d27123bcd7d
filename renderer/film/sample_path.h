#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// How the end of a sample's ray was shaded: in a batch, or one by one for a reason.
enum class SamplePath : std::uint8_t {
  lanes,       ///< a surface in a batch, with SIMD
  background,  ///< the ray hit nothing
  face,        ///< a face of an analytic shape
  line,        ///< a lit line or point
  blended,     ///< a blended surface, where only reflections are wanted
  coplanar,    ///< blended surfaces in one plane
  bare_light,  ///< a reflected ray that hits a light without geometry
  lighting,    ///< the light rule or the background needs the whole shader
  not_finite,  ///< a value of the batch is not finite
  bounce,      ///< light from one surface to another
};
inline constexpr std::size_t sample_path_count = 10;

/// The names of the paths in statistics, in the order of their values.
inline constexpr std::array<const char*, sample_path_count> sample_path_names{
    "lanes",    "background", "face",     "line",       "blended",
    "coplanar", "bare_light", "lighting", "not_finite", "bounce"};

}  // namespace asos
