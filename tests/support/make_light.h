#pragma once

#include "renderer/scene/make_light.h"

namespace asos::test {

using asos::make_bulb, asos::make_panel, asos::make_sun;

}  // namespace asos::test
