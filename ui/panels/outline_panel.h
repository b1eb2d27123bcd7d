#pragma once

#include "ui/node_tree.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace asos::ui {

/// The person's choice among the scene's objects.
struct OutlineChoice {
  int selected = -1;                   ///< of World::parts; -1: none
  std::optional<glm::ivec2> followed;  ///< the clicked pixel whose object was selected
  bool scroll_to_selected = false;     ///< the list does not show it yet
  std::string find;                    ///< letters that the names of listed objects hold
  bool by_node = true;                 ///< the list is the tree of nodes, where there is one
  int node = -1;                       ///< the chosen one of them; -1: none
  NodeTree tree;                       ///< of the open scene
  std::set<int> open;                  ///< the nodes that show their children
  std::weak_ptr<const Geometry> tree_of;
  std::string tree_source;  ///< the file and the number of its scene
};

/// glTF's names of the extensions that a material asks for, in the order of the alphabet.
[[nodiscard]] std::vector<std::string> extensions_of(const Material& material);

/// The scene's tree of nodes, or its materials with the objects that have them; hides and shows
/// these. `picked`: the pixel that was clicked, whose object is selected. Returns what to tell,
/// or nothing.
[[nodiscard]] std::string outline_panel(Controls& controls, Previewer& previewer,
                                        OutlineChoice& choice, std::optional<glm::ivec2> picked);

}  // namespace asos::ui
