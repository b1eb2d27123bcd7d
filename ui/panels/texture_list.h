#pragma once

#include "renderer/world/world.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// Lists the textures of a material: thumbnail, use with its channels, name and size.
void texture_list(Controls& controls, const World& world, const Material& material);

}  // namespace asos::ui
