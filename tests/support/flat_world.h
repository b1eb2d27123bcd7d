#pragma once

#include "renderer/world/world.h"

#include <utility>

namespace asos::test {

/// The flattened surfaces of a scene, without the rest.
inline Result<World> flat_world(const Scene& scene) {
  return flatten(scene).map([](FlattenedScene flattened) { return std::move(flattened.world); });
}

}  // namespace asos::test
