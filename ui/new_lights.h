#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace asos::ui {

/// A ball halfway between the viewer and what he looks at, that makes a white surface there half
/// white.
[[nodiscard]] Light new_light(glm::dvec3 eye, glm::dvec3 subject, double scene_radius);

/// The flat piece of surface around a triangle as a light of 1 nit that shines to the side of
/// `eye`: a rectangle or polygon just before it. Nothing where the piece has no area.
[[nodiscard]] std::optional<Light> light_on_face(const RenderScene& scene, std::uint32_t triangle,
                                                 glm::dvec3 eye);

}  // namespace asos::ui
