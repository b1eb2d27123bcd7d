#pragma once

#include "renderer/film/film.h"
#include "renderer/session/render_session.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The content of a pixel that matters for antialiasing. If several apply, the first counts.
enum class Region : std::uint8_t {
  outlines,     ///< ASOS splits it for an outline, a crease, an intersection or a cut-out
  penumbrae,    ///< a shadow's edge splits it, or an extended light is partially occluded
  reflections,  ///< an edge in a mirror splits it, or the surface reflects
  textures,     ///< a textured surface
  rest,
};
inline constexpr std::size_t region_count = 5;
inline constexpr std::array<const char*, region_count> region_names{
    "outlines", "penumbrae", "reflections", "textures", "rest"};

/// A region for each pixel, and the split map from which they follow.
struct RegionMap {
  int width = 0;
  int height = 0;
  std::vector<Region> region;             ///< row-major from the top left
  std::vector<std::uint8_t> split_value;  ///< of the split map by level: SplitMapKey::value
  std::vector<SplitCause> cause;
};

/// Returns the settings for finding the regions: ASOS with MAX 4 and EPS 1/256.
[[nodiscard]] RenderSettings region_settings(RenderSettings settings);

/// Returns the regions of a picture; `film` is its rendering with `region_settings`. A pixel's
/// content is that at its centre.
[[nodiscard]] RegionMap find_regions(const Snapshot& snapshot, const Film& film);

}  // namespace asos
