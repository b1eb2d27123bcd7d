#pragma once

#include "ui/edited_light.h"
#include "ui/panels/controls.h"

#include <glm/glm.hpp>

namespace asos::ui {

[[nodiscard]] const char* light_kind_name(LightKind kind);

/// What a light is edited in.
struct LightSurroundings {
  SceneSize scene;
  SceneSize looked_at;     ///< where a light of another kind is to be as bright as before
  glm::dvec3 origin{0.0};  ///< the world's
  bool keep_power = true;  ///< of a flat light whose size is edited
};

/// One light's controls: its kind, brightness, size, place and direction. Whether anything was
/// changed.
bool edit_light(Controls& controls, EditedLight& edited, const LightSurroundings& around);

}  // namespace asos::ui
