#pragma once

#include "ui/edited_light.h"
#include "ui/panels/controls.h"

#include <glm/glm.hpp>

namespace asos::ui {

/// Context for editing a light.
struct LightSurroundings {
  SceneSize scene;
  SceneSize looked_at;     ///< where a light keeps its brightness when its kind changes
  glm::dvec3 origin{0.0};  ///< World::origin
  bool keep_power = true;  ///< keep the power of a flat light when its size changes
};

/// Controls of one light: kind, brightness, size, place and direction. Returns whether anything was
/// changed.
bool edit_light(Controls& controls, EditedLight& edited, const LightSurroundings& around);

}  // namespace asos::ui
