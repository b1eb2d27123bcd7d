#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A person's wish to open another scene, or to load the open one again.
struct OpenChoice {
  std::string wanted;   ///< a source; empty: none
  bool reload = false;  ///< the open scene's file
};

/// Opens the scene at once where `losses` is empty; else asks, and lists them.
void open_question(Controls& controls, OpenScene& scene, OpenChoice& choice,
                   const std::vector<std::string>& losses);

}  // namespace asos::ui
