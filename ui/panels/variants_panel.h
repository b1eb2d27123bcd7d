#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// The variants of the file's materials (KHR_materials_variants), where it has any, to choose one.
void variants_panel(Controls& controls, OpenScene& scene);

}  // namespace asos::ui
