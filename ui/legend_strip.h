#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/split_map.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A colour of a split map and its meaning.
struct LegendEntry {
  glm::u8vec3 colour{0};
  std::string words;
};
[[nodiscard]] std::string legend_title(SplitMapColours colours);
[[nodiscard]] std::vector<LegendEntry> legend_entries(SplitMapColours colours);

/// Adds a legend of the split map's colours below the picture, of the picture's width, in the
/// current Dear ImGui font.
void add_legend(RgbImage& image, SplitMapColours colours);

}  // namespace asos::ui
