#pragma once

#include "renderer/lights/lighting.h"
#include "renderer/prepared/render_scene.h"
#include "tests/support/tiny_world.h"

#include <memory>
#include <utility>
#include <vector>

namespace asos::test {

/// A world with its hierarchies at a fixed address; that of the rays knows the parts of `lights`.
inline std::shared_ptr<Geometry> make_geometry(World world, const std::vector<Light>& lights = {}) {
  auto geometry = std::make_shared<Geometry>();
  geometry->world = std::move(world);
  geometry->render_features = find_render_features(geometry->world);
  geometry->rays =
      std::move(RayScene::build(geometry->world, alpha_at, lights, {}, passage_at).value());
  geometry->boundaries.set(FeatureSet(geometry->world));
  geometry->object_spheres = object_spheres(geometry->world);
  geometry->name = "tiny";
  return geometry;
}

inline std::shared_ptr<const RenderScene> make_render_scene(World world,
                                                            std::vector<Light> lights = {}) {
  auto geometry = make_geometry(std::move(world), lights);
  Lighting lighting = prepare_lighting(geometry->world, std::move(lights));
  return unedited_scene(std::move(geometry), std::move(lighting));
}

inline std::shared_ptr<const RenderScene> make_render_scene(FlattenedScene scene) {
  return make_render_scene(std::move(scene.world), std::move(scene.lights));
}

}  // namespace asos::test
