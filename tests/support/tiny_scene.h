#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/lights/light_cuts.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/shade.h"
#include "renderer/world/needs.h"
#include "tests/support/tiny_world.h"

#include <memory>
#include <utility>

namespace asos::test {

/// A world with the hierarchies it needs, where it stays.
inline std::shared_ptr<const RenderScene> make_render_scene(World world) {
  auto scene = std::make_shared<RenderScene>();
  scene->world = std::move(world);
  scene->needs = find_needs(scene->world);
  scene->index->rays = std::move(RayScene::build(scene->world, alpha_at).value());
  scene->index->features = FeatureSet(scene->world);
  scene->object_spheres = object_spheres(scene->world);
  scene->light_cuts = find_light_cuts(scene->world);
  scene->bare_lights = find_bare_lights(scene->world);
  scene->name = "tiny";
  return scene;
}

}  // namespace asos::test
