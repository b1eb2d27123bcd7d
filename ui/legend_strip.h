#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/split_cause.h"
#include "renderer/film/split_map.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asos::ui {

/// A colour of a split map and its meaning.
struct LegendEntry {
  glm::u8vec3 colour{0};
  std::string words;
};
[[nodiscard]] std::string legend_title(SplitMapColours colours);

/// How often each cause occurs in a picture.
struct CauseCounts {
  std::array<std::size_t, split_cause_count> pixels{};
  std::size_t finished = 0;      ///< final pixels
  std::size_t ended_by_max = 0;  ///< of these
};
[[nodiscard]] CauseCounts count_causes(const Film& film);
/// The map's colours with their meaning; of the causes those that occur.
[[nodiscard]] std::vector<LegendEntry> legend_entries(SplitMapColours colours,
                                                      const CauseCounts& causes);

/// A labelled value on the scale of rays or time.
struct CostStep {
  double value;
  const char* words;
};
[[nodiscard]] std::span<const CostStep> cost_steps(SplitMapColours colours);

/// Adds a legend of the split map's colours below the picture, of the picture's width, in the
/// current Dear ImGui font.
void add_legend(RgbImage& image, SplitMapColours colours, const CauseCounts& causes);

}  // namespace asos::ui
