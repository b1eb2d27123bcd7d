#pragma once

#include "app/opened_scene.h"
#include "app/picture_options.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"

#include <string>

namespace asos {

/// Sets the exposure of all pictures where nobody chose a number: see usual_exposure. An animation
/// is metered at rest, so that its frames may be rendered in any order. `picture`: what `scene` is
/// prepared by. Returns a note for the person; empty: there is nothing to say.
[[nodiscard]] Result<std::string> choose_exposure(PictureArguments& wanted, OpenedScene& scene,
                                                  const PictureDescription& picture);

}  // namespace asos
