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

/// The state of the outline panel.
struct OutlineChoice {
  int selected = -1;                   ///< index into World::parts; -1: none
  std::optional<glm::ivec2> followed;  ///< the pixel whose object was selected last
  bool scroll_to_selected = false;     ///< the list has yet to scroll to it
  std::string find;                    ///< text that the listed objects' names contain
  bool by_node = true;                 ///< list the tree of nodes, if the scene has one
  int node = -1;                       ///< the selected node; -1: none
  NodeTree tree;                       ///< of the open scene
  std::set<int> open;                  ///< the unfolded nodes
  std::weak_ptr<const Geometry> tree_of;
  std::string tree_source;  ///< the file and the number of its scene
};

/// Names of the glTF extensions that a material uses, in alphabetical order.
[[nodiscard]] std::vector<std::string> extensions_of(const Material& material);

/// Index into World::parts of the object at a pixel; -1: none.
[[nodiscard]] int object_at(const Previewer& previewer, glm::ivec2 pixel);
/// Selects the object at a pixel, or none on the background, when another pixel is pointed at.
void select_at(const Previewer& previewer, OutlineChoice& choice,
               std::optional<glm::ivec2> pointed);
/// Ascending indices into World::parts of the selected objects: those below the selected node.
[[nodiscard]] std::vector<int> selected_objects(const OpenScene& scene,
                                                const OutlineChoice& choice);
/// These return a message.
std::string hide_selected(OpenScene& scene, OutlineChoice& choice);
std::string isolate_selected(OpenScene& scene, OutlineChoice& choice);
std::string show_hidden(OpenScene& scene);

/// Lists the scene's nodes, or its materials with their objects, and hides or shows objects.
/// Returns a message, or nothing.
[[nodiscard]] std::string outline_panel(Controls& controls, Previewer& previewer,
                                        OutlineChoice& choice);

}  // namespace asos::ui
