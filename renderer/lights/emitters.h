#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Returns the radiance (nits) of a triangle's front side at (b1, b2): factor, strength, texture,
/// and alpha cut-off or blending.
using EmissionAt = glm::vec3 (*)(const World& world, std::uint32_t triangle, float b1, float b2);

/// Largest number of lights of a part, and of one curved connected piece.
inline constexpr std::size_t max_lights_of_part = 64;
inline constexpr std::size_t max_lights_of_curved_piece = 16;

/// Returns whether a material emits: strength and factor above 0, and not unlit, since glTF ignores
/// the emission of unlit materials (KHR_materials_unlit).
[[nodiscard]] bool emits(const Material& material);

/// Returns lights that represent the emissive surfaces of `world`: every part whose material emits,
/// except those that show a light of the scene already (Part::shows_light). `own_part` is the part.
/// The power is that of the triangles: pi * L * area of the front sides. Each piece, connected by
/// edges with the same positions, is replaced by its shape:
/// - Flat regions become polygons with their exact outlines, rectangles or disks. Those with a
///   texture or a mask, without holes, become up to `max_lights_of_curved_piece` lights.
/// - A round blob becomes a ball of the same area, I = L A / 4 candela.
/// - A long straight tube becomes a linear light, I = L A / pi candela: a line that emits with the
///   sine of the angle to it has the power pi^2 I.
/// - Other curved pieces, and curved textured ones, become rectangles. Each has the mean normal and
///   the area of a part with similar normals and emission. Smaller pieces in the scene get fewer.
/// If a part has more lights than `max_lights_of_part`, its dimmer pieces become one light each,
/// and those near to each other one together. Emission is averaged over each piece. Texels below
/// 1/250 of the material's emission, and triangles below 1/1000, are artefacts of image compression
/// and give no light. Double-sided surfaces emit from both sides, but those that enclose a space
/// only outwards. Surfaces without area, or with emission that is not finite, give no light.
[[nodiscard]] std::vector<Light> emissive_lights(const World& world, EmissionAt emission);

/// Returns the mean irradiance, in lux (largest channel), of flat, linear and point lights on a
/// surrounding sphere of `radius`: their power over its area. 0 for radius 0.
[[nodiscard]] double mean_irradiance(std::span<const Light> lights, double radius);

}  // namespace asos
