#include "renderer/prepared/with_ground.h"

#include "renderer/prepared/rebuilt_geometry.h"
#include "renderer/world/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace asos {
namespace {

std::shared_ptr<const Lighting> lighting_on(const World& world, const Lighting& before) {
  Lighting lighting = prepare_lighting(world, before.lights);
  lighting.default_lights_added = before.default_lights_added;
  return std::make_shared<const Lighting>(std::move(lighting));
}

Result<std::shared_ptr<const RenderScene>> in_memory(const RenderScene& scene, Ground ground,
                                                     const World* as) {
  World world = scene.world();
  if (world.lines_and_points.drawn()) draw_lines(world, {{}, 1, 0.0});  // removes the lines
  const AnimationInvariants& stage = scene.geometry->stage;
  put_on_ground(world, ground, stage.floor, as, stage.whole);
  if (world.triangles.size() > most_triangles)
    return unexpected(Error{scene.geometry->source,
                            fmt::format("has {} triangles with its ground; the limit is {}",
                                        world.triangles.size(), most_triangles)});
  auto geometry = rebuilt_geometry(scene, std::move(world), scene.own_lighting->lights);
  if (!geometry) return unexpected(geometry.error());
  RenderScene grounded = scene;
  grounded.exposure.reset();
  grounded.geometry = *std::move(geometry);
  // The materials' ratios may have been edited; the ground has its own.
  MaterialDfrs dfrs = dfrs_of(grounded.world());
  std::copy_n(scene.dfrs().begin(), materials_without_ground(scene.world()), dfrs.begin());
  grounded.materials = std::make_shared<const MaterialDfrs>(std::move(dfrs));
  // Lights refer to the world's parts by number.
  const bool own = scene.lighting == scene.own_lighting;
  grounded.own_lighting = lighting_on(grounded.world(), *scene.own_lighting);
  grounded.lighting = own ? grounded.own_lighting : lighting_on(grounded.world(), *scene.lighting);
  return assembled(std::move(grounded));
}

}  // namespace

Result<std::shared_ptr<const RenderScene>> with_ground(std::shared_ptr<const RenderScene> scene,
                                                       Ground ground, const World* as) {
  const bool extent = !bounds_without_ground(scene->world()).empty();
  if (ground == ground_of(scene->world()) || !extent) return scene;
  try {
    return in_memory(*scene, ground, as);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene->geometry->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
