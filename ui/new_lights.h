#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace asos::ui {

/// A sphere light halfway between the eye and the subject, bright enough to make a white surface
/// there half white.
[[nodiscard]] Light new_light(glm::dvec3 eye, glm::dvec3 subject, double scene_radius);

/// Makes a light of 1 cd/m² from the flat piece of surface around a triangle: a rectangle or
/// polygon just in front of it, emitting towards `eye`. Returns nothing if the piece has no area.
[[nodiscard]] std::optional<Light> light_on_face(const RenderScene& scene, std::uint32_t triangle,
                                                 glm::dvec3 eye);

}  // namespace asos::ui
