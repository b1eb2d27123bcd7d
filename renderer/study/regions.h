#pragma once

#include "renderer/film/film.h"
#include "renderer/session/render_session.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The content of a pixel, as far as it matters for antialiasing; where several hold, the first.
enum class Region : std::uint8_t {
  outlines,     ///< ASOS splits it for an outline, a crease, an intersection or a cut-out
  penumbrae,    ///< a shadow's edge splits it, or a light of some size is seen in part
  reflections,  ///< an edge in a mirror splits it, or a surface that mirrors
  textures,     ///< a textured surface
  rest,
};
inline constexpr std::size_t region_count = 5;
inline constexpr std::array<const char*, region_count> region_names{
    "outlines", "penumbrae", "reflections", "textures", "rest"};

/// A region for each pixel, and the split map that they come from.
struct RegionMap {
  int width = 0;
  int height = 0;
  std::vector<Region> region;  ///< row-major from the top left
  std::vector<std::uint8_t> split_level;
  std::vector<SplitCause> cause;
};

/// The settings that the regions are found at: ASOS with MAX 4 and EPS 1/256.
[[nodiscard]] RenderSettings region_settings(RenderSettings settings);

/// The regions of a picture that `film` is the rendering of, at `region_settings`. A pixel's
/// content is that at its centre.
[[nodiscard]] RegionMap find_regions(const Snapshot& snapshot, const Film& film);

}  // namespace asos
