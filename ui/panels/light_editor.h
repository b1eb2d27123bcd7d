#pragma once

#include "ui/edited_light.h"
#include "ui/panels/controls.h"

#include <glm/glm.hpp>

namespace asos {

[[nodiscard]] const char* light_kind_name(LightKind kind);

/// One light's controls: its kind, brightness, size, place and direction. `origin` is the world's.
/// Whether anything was changed.
bool edit_light(Controls& controls, EditedLight& edited, const SceneSize& scene, glm::dvec3 origin);

}  // namespace asos
