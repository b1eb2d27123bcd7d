#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A request to open another scene.
struct OpenChoice {
  std::string wanted;  ///< a source; empty: none
};

/// Opens the scene immediately if `losses` is empty; otherwise lists them and asks for
/// confirmation.
void open_question(Controls& controls, OpenScene& scene, OpenChoice& choice,
                   const std::vector<std::string>& losses);

}  // namespace asos::ui
