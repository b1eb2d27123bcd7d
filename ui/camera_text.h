#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>

namespace asos::ui {

/// The command-line options for a perspective camera (relative to `origin`) that looks at `target`:
/// "--look-at ex,ey,ez,tx,ty,tz --fov 45", in file units and degrees. They have no roll. Empty for
/// an orthographic camera.
[[nodiscard]] std::string camera_options(const Camera& camera, glm::dvec3 target,
                                         glm::dvec3 origin);
/// The camera (relative to `origin`) as the JSON of a glTF file with one camera and its node.
[[nodiscard]] std::string camera_as_gltf(Camera camera, glm::dvec3 origin);

}  // namespace asos::ui
