#pragma once

#include "app/opened_scene.h"
#include "app/picture_options.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"

#include <string>

namespace asos {

/// Sets the exposure of all pictures if the command line sets none: see usual_exposure. Meters an
/// animation at rest, so that frames can be rendered in any order. `picture`: the description that
/// `scene` is prepared with. Returns a note for the user; empty: none.
[[nodiscard]] Result<std::string> choose_exposure(PictureArguments& wanted, OpenedScene& scene,
                                                  const PictureDescription& picture);

}  // namespace asos
