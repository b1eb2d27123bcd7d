#pragma once

#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The person's choice among the scene's objects.
struct OutlineChoice {
  int selected = -1;                   ///< of World::parts; -1: none
  std::optional<glm::ivec2> followed;  ///< the clicked pixel whose object was selected
  bool scroll_to_selected = false;     ///< the list does not show it yet
  std::string find;                    ///< letters that the names of listed objects hold
};

/// glTF's names of the extensions that a material asks for, in the order of the alphabet.
[[nodiscard]] std::vector<std::string> extensions_of(const Material& material);

/// The scene's materials with what each asks for, the objects that have them, and which of these
/// are shown. `picked`: the pixel that was clicked, whose object is selected. Returns what to tell,
/// or nothing.
[[nodiscard]] std::string outline_panel(Controls& controls, Previewer& previewer,
                                        OutlineChoice& choice, std::optional<glm::ivec2> picked);

}  // namespace asos
