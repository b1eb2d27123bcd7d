#pragma once

#include <string_view>

namespace asos {

/// Whether there is something to say about a section of the panel.
[[nodiscard]] bool has_section_help(std::string_view section);
/// Says it in the current Dear ImGui window: a small drawing and two sentences.
void section_help(std::string_view section);

}  // namespace asos
