#pragma once

#include "ui/panels/controls.h"
#include "ui/scene_edits.h"

namespace asos::ui {

/// The built-in environments as small panoramas. A click sets one as the sky.
void sky_thumbnails(Controls& controls, SceneEdits& edits);

}  // namespace asos::ui
