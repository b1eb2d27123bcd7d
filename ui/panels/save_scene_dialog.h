#pragma once

#include "ui/panels/controls.h"

#include <string>

namespace asos::ui {

/// A person's choice of where to write the scene.
struct SaveSceneChoice {
  std::string path;    ///< .glb or .gltf; empty: the next that is free
  bool show = false;   ///< the dialog
  bool asked = false;  ///< it was answered: to be saved now
};

void save_scene_dialog(Controls& controls, SaveSceneChoice& choice);

}  // namespace asos::ui
