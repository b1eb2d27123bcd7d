#include "renderer/prepared/without_objects.h"

#include "renderer/prepared/rebuilt_geometry.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace asos {
namespace {

/// Returns the lights whose own parts are not hidden, with the numbers of the parts that are left.
std::vector<Light> lights_left(const std::vector<Light>& lights,
                               std::span<const std::uint8_t> hidden) {
  std::vector<std::int32_t> before(1, 0);  // hidden parts before each part
  for (const std::uint8_t flag : hidden) before.push_back(before.back() + (flag ? 1 : 0));
  std::vector<Light> left;
  for (const Light& light : lights) {
    const auto part = static_cast<std::size_t>(light.own_part);
    if (light.own_part >= 0 && part < hidden.size() && hidden[part]) continue;
    left.push_back(light);
    if (light.own_part >= 0) left.back().own_part -= before[std::min(part, hidden.size())];
  }
  return left;
}

Result<std::shared_ptr<const RenderScene>> in_memory(const RenderScene& whole,
                                                     std::span<const std::uint8_t> hidden,
                                                     std::shared_ptr<PosableScene> rig) {
  World world = whole.world();
  if (world.lines_and_points.drawn()) draw_lines(world, {{}, 1, 0.0});  // removes the lines
  world = without_parts(world, hidden);
  const Lighting& before = *whole.own_lighting;
  std::vector<Light> lights = lights_left(before.lights, hidden);
  auto geometry = rebuilt_geometry(whole, std::move(world), lights);
  if (!geometry) return unexpected(geometry.error());
  Geometry& built = **geometry;
  built.rig = std::move(rig);
  if (built.stage.whole.empty()) built.stage.whole = bounds_without_ground(whole.world());
  Lighting lighting = prepare_lighting(built.world, std::move(lights));
  lighting.default_lights_added = before.default_lights_added;
  return unedited_scene(*std::move(geometry), std::move(lighting), whole.forced);
}

}  // namespace

std::shared_ptr<const RenderScene> without_edits(const std::shared_ptr<const RenderScene>& scene) {
  const MaterialDfrs own = dfrs_of(scene->world());
  if (scene->lighting == scene->own_lighting && scene->dfrs() == own && !scene->exposure)
    return scene;
  RenderScene unedited = *scene;
  unedited.exposure.reset();
  unedited.lighting = scene->own_lighting;
  unedited.materials = std::make_shared<const MaterialDfrs>(own);
  return assembled(std::move(unedited));
}

Result<std::shared_ptr<const RenderScene>> without_objects(
    const std::shared_ptr<const RenderScene>& whole, std::span<const std::uint8_t> hidden,
    std::shared_ptr<PosableScene> rig) {
  try {
    return in_memory(*whole, hidden, std::move(rig));
  } catch (const std::bad_alloc&) {
    return unexpected(Error{whole->geometry->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
