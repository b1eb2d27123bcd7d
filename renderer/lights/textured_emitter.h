#pragma once

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitters.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// A flat light and the triangles that it stands for.
struct FlatEmitter {
  Light light;
  Piece region;
};

/// Whether `split_by_texture` can cut it: a rectangle, a disk or a polygon without holes.
[[nodiscard]] bool can_be_split(const FlatEmitter& emitter);

/// Flat lights that a texture, or an alpha mask, paints, as up to `most` lights that shine each
/// with the mean of what it covers: cut by rectangles where that leaves the least variance, by
/// summed tables of the emission. What is black gives no light. A light that shines evenly stays as
/// it is.
[[nodiscard]] std::vector<Light> split_by_texture(const World& world, EmissionAt emission,
                                                  std::span<const EmitterTriangle> triangles,
                                                  std::span<const FlatEmitter> emitters,
                                                  std::size_t most);

}  // namespace asos
