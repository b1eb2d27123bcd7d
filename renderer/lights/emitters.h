#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Radiance (nits) that a triangle's front side emits at (b1, b2): factor, strength, texture and
/// what an alpha cut-off or blending leaves of it.
using EmissionAt = glm::vec3 (*)(const World& world, std::uint32_t triangle, float b1, float b2);

/// No part gives more lights than this; of one curved connected piece no more than the second.
inline constexpr std::size_t max_lights_of_part = 64;
inline constexpr std::size_t max_lights_of_curved_piece = 16;

/// Whether a material emits at all: strength and factor above 0, and not unlit, whose emission glTF
/// ignores (KHR_materials_unlit: nothing but the base colour counts).
[[nodiscard]] bool emits(const Material& material);

/// The lights that stand for the emissive surfaces of `world`: every part whose material emits,
/// but those that show a light of the scene already (Part::shows_light). `own_part` is the part.
/// The power pi * L * area of the front sides is that of the triangles. Piece by piece, joined by
/// edges with positions in common:
///  - flat regions become polygons with their exact outlines, rectangles or disks; those that a
///    texture or a mask paints, without holes, become up to `max_lights_of_curved_piece` lights;
///  - a round blob becomes a ball of the same area, I = L A / 4 candela;
///  - a long straight tube becomes a linear light, I = L A / pi candela: a line that shines with
///    the sine of the angle to it gives off pi^2 I in all;
///  - what is curved otherwise, or curved and painted, becomes rectangles, one for a stretch of
///    similar normals and emission, with the mean normal and the same area: the fewer the smaller
///    the piece is in the scene.
/// Where a part has more lights than `max_lights_of_part`, its dimmer pieces become one light each,
/// and those near to each other one together. Emission is averaged over each piece; texels that
/// leave less than 1/250 of the material's emission, and triangles with less than 1/1000, are what
/// image compression makes of black and give no light. Double-sided surfaces shine both ways, but
/// those that enclose a space only outwards. Surfaces without area, or of emission that is not
/// finite, give nothing.
[[nodiscard]] std::vector<Light> emissive_lights(const World& world, EmissionAt emission);

/// The mean irradiance that flat, linear and point lights like these give to a sphere of `radius`
/// around them: their power over its area, in lux (largest channel). 0 for radius 0.
[[nodiscard]] double mean_irradiance(std::span<const Light> lights, double radius);

}  // namespace asos
