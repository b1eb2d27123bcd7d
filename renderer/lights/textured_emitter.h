#pragma once

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/emitters.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// A rectangle that a texture, or an alpha mask, paints, as up to `most` rectangles that shine each
/// with the mean of what it covers: cut where that leaves the least variance, by summed tables of
/// the emission. `rectangle` stands for `region`. What is black gives no light. The rectangle
/// itself where it shines evenly.
[[nodiscard]] std::vector<Light> split_by_texture(const World& world, EmissionAt emission,
                                                  const Light& rectangle,
                                                  std::span<const EmitterTriangle> triangles,
                                                  std::span<const std::uint32_t> region,
                                                  std::size_t most);

}  // namespace asos
