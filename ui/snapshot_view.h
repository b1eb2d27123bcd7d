#pragma once

#include "renderer/comparison/method.h"
#include "renderer/geometry/view.h"
#include "renderer/session/render_session.h"

namespace asos::ui {

/// The picture's view, as its render uses it.
[[nodiscard]] inline View view_of(const Snapshot& picture) {
  return View(viewed_camera(*picture.scene, picture.camera, picture.settings),
              picture.settings.width, picture.settings.height,
              radius_around_origin(picture.scene->world().bounds));
}

}  // namespace asos::ui
