#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// Lists the file's material variants (KHR_materials_variants), to choose one; nothing if it has
/// none.
void variants_panel(Controls& controls, OpenScene& scene);

}  // namespace asos::ui
