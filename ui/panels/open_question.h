#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A request to open another scene, or to reload the open one.
struct OpenChoice {
  std::string wanted;   ///< a source; empty: none
  bool reload = false;  ///< the open scene's file
};

/// Opens the scene immediately if `losses` is empty; otherwise lists them and asks for
/// confirmation.
void open_question(Controls& controls, OpenScene& scene, OpenChoice& choice,
                   const std::vector<std::string>& losses);

}  // namespace asos::ui
