#pragma once

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitters.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// A flat light and the triangles that it represents.
struct FlatEmitter {
  Light light;
  Piece region;
};

/// Returns whether `split_by_texture` can cut it: a rectangle, a disk or a polygon without holes.
[[nodiscard]] bool can_be_split(const FlatEmitter& emitter);

/// Divides flat lights with a texture or an alpha mask into up to `most` lights, each with the mean
/// emission of its area. Cuts along rectangles for the least variance, with summed-area tables of
/// the emission. Black areas give no light. A light with even emission is not divided.
[[nodiscard]] std::vector<Light> split_by_texture(const World& world, EmissionAt emission,
                                                  std::span<const EmitterTriangle> triangles,
                                                  std::span<const FlatEmitter> emitters,
                                                  std::size_t most);

}  // namespace asos
