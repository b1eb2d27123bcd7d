#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// Returns, for each light in order, the lines where triangles of the world pass through it. The
/// light is a rectangle, polygon or disk, and the triangles are not of its own part. A triangle
/// that ends on the light's emitting side counts, too. These lines bound the visible part of the
/// light, although no mesh edge runs there. Pieces next to the light or along its outline,
/// triangles in its plane, and triangles that touch it from behind do not count; other lights have
/// none. A light keeps at most `most_light_intersections`, from the first triangles. Takes time for
/// each triangle once, and for each pair of a light and a run of triangles.
[[nodiscard]] LightIntersections find_light_intersections(const World& world,
                                                          std::span<const PreparedLight> lights);

/// Returns which lights are balls or capsules that other parts' triangles reach into. The parts of
/// these triangles inside the light hide nothing of it, but no plane separates them from the parts
/// outside.
[[nodiscard]] std::vector<bool> find_entered_balls(const World& world,
                                                   std::span<const PreparedLight> lights);

/// More than any shadow pyray cuts along. With more of them, the light is sampled.
inline constexpr std::size_t most_light_intersections = 512;

}  // namespace asos
