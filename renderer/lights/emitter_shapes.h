#pragma once

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitter_moments.h"

#include <optional>
#include <span>

namespace asos {

/// Lights that stand for pieces of an emissive surface. All keep the power pi * L * area of the
/// front sides; name and own part are left to the caller. nullopt: the piece has another shape, or
/// a float does not hold the light's strength.

/// A flat region by its outlines, rectangles as such. With more than `most_corners` a round one is
/// a disk, others are nullopt; so are outlines that do not enclose the area of the triangles, which
/// overlap then.
inline constexpr std::size_t most_corners = 64;
[[nodiscard]] std::optional<Light> polygon_light(std::span<const EmitterTriangle> triangles,
                                                 const Piece& region, bool two_sided);

/// A round blob that faces outwards all around: a ball.
[[nodiscard]] std::optional<Light> ball_light(const Moments& moments);

/// A long straight tube that faces outwards: a linear light.
[[nodiscard]] std::optional<Light> tube_light(std::span<const EmitterTriangle> triangles,
                                              const Piece& piece, const Moments& moments);

/// The light of a piece that faces one way by and large, flat or not: a rectangle at its middle,
/// along its longest spread (Moments::spread) and of its area; or, for several pieces with gaps
/// between, as large as they spread if that is more. For a piece that faces all ways: a ball of its
/// area.
enum class Extent { area, spread };
[[nodiscard]] std::optional<Light> one_light(const Moments& moments, bool two_sided, Extent extent);

}  // namespace asos
