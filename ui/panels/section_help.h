#pragma once

#include <span>
#include <string_view>

namespace asos::ui {

/// Whether there is help for a section of the panel.
[[nodiscard]] bool has_section_help(std::string_view section);
/// Shows the help in the current Dear ImGui window: a small drawing and two sentences.
void section_help(std::string_view section);

/// A pixel in the drawing of "Antialiasing".
struct SketchedPixel {
  int edges = 0;   ///< that cross it
  int levels = 0;  ///< that it is split to
};
[[nodiscard]] std::span<const SketchedPixel> sketched_pixels();

}  // namespace asos::ui
