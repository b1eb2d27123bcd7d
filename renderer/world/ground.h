#pragma once

#include "renderer/settings/choices.h"
#include "renderer/world/world.h"

#include <optional>

namespace asos {

/// Puts the surfaces of a world whose lines and points are not drawn on this ground, in place of
/// the one that they stand on: a round plate under the middle of their bounds, ground_radii of
/// their bounding sphere wide. It lies below the lowest point by so little that what ends there is
/// not mistaken for it. A mirroring plate blurs by a defocusing ratio: sharp at grazing angles. It
/// is the last of the parts that are not of lines and points, and its material the last one. A
/// world without extent stays as it is. `floor`: height in place of that of the lowest point.
void put_on_ground(World& world, Ground ground, std::optional<double> floor = std::nullopt);

inline constexpr double ground_radii = 10.0;

/// What it stands on.
[[nodiscard]] Ground ground_of(const World& world);

// The world without its ground, for all that is told of it.

/// Without lines and points, too, whose surfaces follow the camera.
[[nodiscard]] Box bounds_without_ground(const World& world);
[[nodiscard]] std::size_t materials_without_ground(const World& world);
[[nodiscard]] std::size_t triangles_without_ground(const World& world);
/// The materials' own; see dfrs_of.
[[nodiscard]] MaterialDfrs dfrs_without_ground(const World& world);

}  // namespace asos
