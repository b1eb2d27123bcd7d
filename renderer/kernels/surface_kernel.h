#pragma once

#include "renderer/kernels/shading_points.h"
#include "renderer/kernels/surface_batch.h"
#include "renderer/shading/footprint.h"

namespace asos {

/// The two steps of shading for a batch of triangle points; textures are sampled between them. The
/// bits of a point depend on the point alone, not on its place in the batch or the instruction set.

/// Computes the geometry of the points, with the bits of surface_point for a point without a normal
/// map. `spacing` is that of the picture; null: all samples are points. Fills the geometry of
/// ShadingPoints.
void place_surfaces(const TriangleBatch& hits, const PixelSpacing* spacing, SurfaceRest& rest,
                    ShadingPoints& points);
/// Computes the same for points that are seen in pictures of their own.
void place_surfaces(const TriangleBatch& hits, const SpacingBatch& spacing, SurfaceRest& rest,
                    ShadingPoints& points);

/// Computes the materials as `viewed` and ShadingPoints::add do for one point, and fills the rest
/// of ShadingPoints. No lights are visible in reflections. Returns false if any value is not
/// finite.
[[nodiscard]] bool view_materials(const SurfaceRest& rest, MaterialBatch& materials,
                                  ShadingPoints& points);

}  // namespace asos
