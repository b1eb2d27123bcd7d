#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace asos {

/// The cause of a pixel's split into several parts: quarters, pieces along an edge, or samples. A
/// pixel has one cause; cause_of (renderer/asos/split_causes.h) selects it if there are several.
enum class SplitCause : std::uint8_t {
  none,
  outline,       ///< the end of a surface: an open edge or a silhouette
  crease,        ///< a kink, or a seam of materials or textures
  intersection,  ///< a line in which surfaces intersect
  shadow,        ///< a shadow's edge
  reflection,    ///< an edge in a reflection
  shading,       ///< only varying shading
  cut_out,       ///< no boundary: split by its samples, as at a texture's holes
  saturation,    ///< so many boundaries that samples cost less than the parts between them
  depth_limit,   ///< boundaries still crossed cells when MAX was reached
  lens,          ///< depth of field: sampled over pixel and lens
  motion,        ///< motion blur: it changes while the shutter is open
};
inline constexpr std::size_t split_cause_count = 12;

/// The names of the causes in statistics, in the order of their values.
inline constexpr std::array<const char*, split_cause_count> split_cause_names{
    "none",    "outline", "crease",     "intersection", "shadow", "reflection",
    "shading", "cut_out", "saturation", "depth_limit",  "lens",   "motion"};

/// The names of the causes as the window and `asos trace` write them, in the order of their values.
inline constexpr std::array<const char*, split_cause_count> split_cause_titles{
    "not split", "silhouette", "crease, seam",   "intersection", "shadow",    "reflection",
    "shading",   "alpha edge", "too many edges", "MAX reached",  "lens blur", "motion blur"};

[[nodiscard]] constexpr const char* title_of(SplitCause cause) {
  return split_cause_titles[static_cast<std::size_t>(cause)];
}

[[nodiscard]] constexpr const char* name_of(SplitCause cause) {
  return split_cause_names[static_cast<std::size_t>(cause)];
}

/// Returns the split map's colour of a cause: sRGB bytes, black for `none` only. The palette is
/// that of Okabe and Ito (Color Universal Design, 2008) with white, brown and two other blues, for
/// colour-blind people.
[[nodiscard]] constexpr glm::u8vec3 split_cause_colour(SplitCause cause) {
  constexpr std::array<std::array<std::uint8_t, 3>, split_cause_count> colours{{{0, 0, 0},
                                                                                {240, 228, 66},
                                                                                {86, 180, 233},
                                                                                {0, 114, 178},
                                                                                {204, 121, 167},
                                                                                {30, 30, 240},
                                                                                {0, 158, 115},
                                                                                {230, 159, 0},
                                                                                {213, 94, 0},
                                                                                {255, 255, 255},
                                                                                {110, 60, 20},
                                                                                {0, 0, 128}}};
  const auto& c = colours[static_cast<std::size_t>(cause)];
  return {c[0], c[1], c[2]};
}

}  // namespace asos
