#pragma once

#include "renderer/settings/choices.h"
#include "renderer/world/world.h"

#include <optional>

namespace asos {

/// Puts a world on this ground in place of its present one; its lines and points must not be drawn.
/// The ground is a round plate under the centre of the bounds. Its width is ground_radii of their
/// bounding sphere. It lies slightly below the lowest point, so that surfaces that end there are
/// not coplanar with it. A reflecting plate blurs by a defocusing ratio: sharp at grazing angles.
/// It is the last part before those of lines and points, and its material is the last one. A world
/// without extent stays as it is. `floor` is a height to use instead of the lowest point's. If `as`
/// has a ground, this one gets its place and width; both worlds have the same origin. `around` are
/// bounds to use instead of the world's; empty: none.
void put_on_ground(World& world, Ground ground, std::optional<double> floor = std::nullopt,
                   const World* as = nullptr, const Box& around = {});

/// Beyond this the default lights add less than a hundredth to the ground's radiance.
inline constexpr double ground_radii = 80.0;
/// The diffuse reflectance of the ground that does not reflect the scene: a grey on which white and
/// black models stand out.
inline constexpr float ground_albedo = 0.38f;

/// Returns the present ground.
[[nodiscard]] Ground ground_of(const World& world);

// The scene without its ground, for descriptions.

/// Returns the bounds without the ground, and without lines and points, whose surfaces follow the
/// camera.
[[nodiscard]] Box bounds_without_ground(const World& world);
/// Returns the number of parts that have surfaces, without the ground. They come first.
[[nodiscard]] std::size_t objects_without_ground(const World& world);
[[nodiscard]] std::size_t parts_without_ground(const World& world);
[[nodiscard]] std::size_t materials_without_ground(const World& world);
[[nodiscard]] std::size_t triangles_without_ground(const World& world);
/// Returns the materials' own defocusing ratios (dfrs_of), without the ground's.
[[nodiscard]] MaterialDfrs dfrs_without_ground(const World& world);

}  // namespace asos
