#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/world/world.h"

namespace asos {

/// The scene data that shadow pyrays need.
struct ShadowScene {
  const World& world;
  const FeatureSet& features;
  const RayScene& rays;
};

}  // namespace asos
