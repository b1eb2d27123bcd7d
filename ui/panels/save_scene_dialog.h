#pragma once

#include "ui/panels/controls.h"

#include <string>

namespace asos::ui {

/// The user's choice of the exported scene's path.
struct SaveSceneChoice {
  std::string path;    ///< .glb or .gltf; empty: the next free name
  bool show = false;   ///< the dialog
  bool asked = false;  ///< the dialog was confirmed: save now
};

void save_scene_dialog(Controls& controls, SaveSceneChoice& choice, bool hides_objects);

}  // namespace asos::ui
