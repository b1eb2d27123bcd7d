#pragma once

#include "renderer/kernels/surface_batch.h"
#include "renderer/shading/sky.h"

#include <array>

namespace asos {

/// The radiance of a sky's picture that a batch of surfaces reflects, in the two parts of
/// reflected_sky.
struct SkyBatch {
  /// Input. 1: the lobe reflects the sky; 0: something else, or a narrower lobe than
  /// SkyLobes::least_roughness, and `by_lobe` will be 0.
  ShadingPoints::Floats lobe_reflects{};
  ShadingPoints::Vectors diffuse, by_lobe;
};

/// Computes the parts for points whose materials are viewed. The bits are those of reflected_sky,
/// whatever the batch and the instruction set.
void reflect_sky(const Sky::PictureLobes& sky, const MaterialBatch& materials,
                 const ShadingPoints& points, SkyBatch& reflected);

}  // namespace asos
