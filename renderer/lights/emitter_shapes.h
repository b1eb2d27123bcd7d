#pragma once

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitter_moments.h"

#include <optional>
#include <span>

namespace asos {

/// Lights that represent pieces of an emissive surface. All keep the power pi * L * area of the
/// front sides; the caller sets name and own part. nullopt: the piece has another shape, or the
/// light's intensity does not fit a float.

/// Returns a flat region as a polygon with its outlines, or as a rectangle if it is one. With more
/// than `most_corners`, a round one becomes a disk, and others are nullopt. Outlines that do not
/// enclose the area of the triangles are nullopt, too; such triangles overlap.
inline constexpr std::size_t most_corners = 64;
[[nodiscard]] std::optional<Light> polygon_light(std::span<const EmitterTriangle> triangles,
                                                 const Piece& region, bool two_sided);

/// Returns a ball for a round blob that faces outwards everywhere.
[[nodiscard]] std::optional<Light> ball_light(const Moments& moments);

/// Returns a linear light for a long straight tube that faces outwards.
[[nodiscard]] std::optional<Light> tube_light(std::span<const EmitterTriangle> triangles,
                                              const Piece& piece, const Moments& moments);

/// Returns one light for a piece that mostly faces one way, flat or not: a rectangle at its centre,
/// along its longest spread (Moments::spread), with its area. With Extent::spread, for several
/// pieces with gaps in between, it is as large as their spread if that is larger. For a piece that
/// faces all ways, returns a ball with its area.
enum class Extent { area, spread };
[[nodiscard]] std::optional<Light> one_light(const Moments& moments, bool two_sided, Extent extent);

}  // namespace asos
