#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// For each light, in their order, where triangles of the world that are not its own part pass
/// through a rectangle, polygon or disk, or end on the side of it that shines. No edge of a mesh
/// runs there, and yet what the light shows ends there. Pieces beside the light or along its
/// outline, triangles in its plane, and triangles that touch it from behind do not count; other
/// lights have none. A light with more intersections than `most_light_intersections` keeps that
/// many, of the first triangles. Takes time for each triangle once, and for each pair of a light
/// and a run of triangles.
[[nodiscard]] LightIntersections find_light_intersections(const World& world,
                                                          std::span<const PreparedLight> lights);

/// Which of the lights are balls that triangles of the world which are not their own part reach
/// into. From there on these hide nothing of the ball; but where a ray enters it no plane tells.
[[nodiscard]] std::vector<bool> find_entered_balls(const World& world,
                                                   std::span<const PreparedLight> lights);

/// More than any shadow pyray cuts along: it then samples the light.
inline constexpr std::size_t most_light_intersections = 512;

}  // namespace asos
