#pragma once

#include "ui/panels/controls.h"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <string>

namespace asos::ui {

/// A tick of a colour scale, at `share`, 0 to 1.
struct ScaleTick {
  float share;
  std::string text;
};
/// Draws a colour scale across the window, by default heat_colour from black to white, with the
/// ticks' texts below it. Records it with these texts.
void scale_strip(Controls& controls, const char* name, const char* tooltip,
                 std::span<const ScaleTick> ticks,
                 const std::function<glm::u8vec3(float)>& colour = {});

}  // namespace asos::ui
