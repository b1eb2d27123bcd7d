#pragma once

#include "renderer/kernels/lit_batch.h"
#include "renderer/kernels/surface_batch.h"
#include "renderer/shading/footprint.h"

namespace asos {

/// Shading's two steps for a batch of points of triangles; between them textures are looked up. The
/// bits of a point depend on the point alone, not on its place in the batch nor on the instructions
/// that the processor has.

/// The geometry of the points, bit for bit as surface_point makes it of one without a map of
/// normals. `spacing`: of the picture; null: all samples are points. Fills what LitBatch knows of
/// geometry.
void place_surfaces(const TriangleBatch& hits, const PixelSpacing* spacing, SurfaceRest& rest,
                    LitBatch& points);

/// What the viewer sees of their materials, as `viewed` makes it of one, and LitBatch::add: the
/// rest of LitBatch. Reflections show no lights. False where anything is not finite, or where a
/// position is not.
[[nodiscard]] bool view_materials(const SurfaceRest& rest, MaterialBatch& materials,
                                  LitBatch& points);

}  // namespace asos
