#include "renderer/geometry/finite.h"
#include "renderer/load_progress.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/rebuilt_geometry.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/shading/cube_sky.h"
#include "renderer/shading/sky.h"
#include "renderer/world/ground.h"
#include "renderer/world/shared_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asos {
namespace {

/// Returns why the renderer cannot use a light; empty: it can. A light without size, or with an
/// invalid direction, emits nothing.
std::string fault_of(const Light& light, std::span<const Light> built) {
  const glm::vec3 power = light.color * light.intensity;
  bool sound = finite(light.position) && finite(light.direction) && finite(light.half_u) &&
               finite(light.half_v) && finite(power) && std::isfinite(light.radius) &&
               std::isfinite(light.angular_diameter_rad) && light.range > 0.0;
  for (const std::vector<glm::dvec3>& outline : light.outlines)
    sound = sound && std::all_of(outline.begin(), outline.end(), finite<3, double, glm::defaultp>);
  if (!sound) return "is not finite";
  const bool known = light.own_part < 0 || std::any_of(built.begin(), built.end(), [&](auto& b) {
                       return b.own_part == light.own_part;
                     });
  return known ? "" : "has an own part that is no light's";
}

Error memory_error(const std::string& source) {
  return {source, "does not fit into this machine's memory"};
}

Error boundaries_error(const RenderScene& scene) {
  return {scene.geometry->source, "its boundaries do not fit into this machine's memory"};
}

std::shared_ptr<const Sky> sky_of_file(const Scene& scene) {
  if (!scene.surroundings) return nullptr;
  return std::make_shared<const Sky>(sky_map_of(*scene.surroundings), 0.0, scene.source);
}

bool gets_default_lighting(const Scene& scene, const World& world, std::span<const Light> of_file,
                           std::span<const Light> emissive) {
  if (scene.added_lighting != AddedLighting::automatic)
    return scene.added_lighting == AddedLighting::environment;
  return !scene.surroundings && needs_default_lighting(world, of_file, emissive);
}

/// Returns whether the search for the default lights sees the same with and without a ground: all
/// its rays start above.
bool looks_from_above(const World& world) {
  const Camera camera = first_camera(world);
  return camera.type == Camera::Type::perspective &&
         camera.world_from_camera[3].y > static_cast<double>(world.bounds.lo.y);
}

void add_ground(World& world, const ChooseGround& choose, const AnimationInvariants& own,
                bool has_stage) {
  if (!choose || world.bounds.empty() || world.triangles.size() + 1000 > most_triangles) return;
  const GroundChoice choice = choose(world, own.has_default_lighting);
  if (choice.ground == Ground::off) return;
  if (own.has_default_lighting && !has_stage && !looks_from_above(world)) return;
  put_on_ground(world, choice.ground, own.floor, choice.as, own.whole);
}

Result<std::shared_ptr<const RenderScene>> prepare_in_memory(const Scene& scene,
                                                             const RenderFeatures& forced,
                                                             const AnimationInvariants* stage,
                                                             const ChooseGround& choose) {
  const auto start = std::chrono::steady_clock::now();
  begin_stage(LoadStage::surfaces);
  auto flattened = stage && stage->meshes
                       ? flatten(scene, most_triangles, stage->origin, *stage->meshes)
                   : stage ? flatten(scene, most_triangles, stage->origin)
                           : flatten(scene, most_triangles);
  if (!flattened) return unexpected(flattened.error());

  // Emissive meshes light every scene, except those that show a light of the file.
  begin_stage(LoadStage::lights);
  std::vector<Light> lights = std::move(flattened->lights);
  std::vector<Light> emissive = lights_of_meshes(flattened->world);
  AnimationInvariants own;
  own.origin = flattened->world.origin;
  own.has_default_lighting = stage
                                 ? stage->has_default_lighting
                                 : gets_default_lighting(scene, flattened->world, lights, emissive);
  std::move(emissive.begin(), emissive.end(), std::back_inserter(lights));
  const Box bounds = flattened->world.bounds;
  if (stage)
    own.floor = stage->floor, own.whole = stage->whole;
  else if (!bounds.empty())
    own.floor = static_cast<double>(bounds.lo.y);
  add_ground(flattened->world, choose, own, stage != nullptr);

  begin_stage(LoadStage::rays);
  // Build this after the emitters, whose sampling depends on whether there are colours.
  auto geometry =
      build_geometry(std::move(flattened->world), lights, forced, stage ? &stage->mips : nullptr,
                     scene.time ? BvhPurpose::moment : BvhPurpose::lasting);
  if (!geometry) return unexpected(Error{scene.source, geometry.error().message()});
  begin_stage(LoadStage::finishing);
  Geometry& built = **geometry;
  if (own.has_default_lighting && stage) {
    own.rig = stage->rig;
    own.default_lighting_inside = stage->default_lighting_inside;
  } else if (own.has_default_lighting) {
    DefaultLighting rig = default_lighting(built.world, bounds, built.rays);
    if (scene.added_lighting == AddedLighting::automatic) own.rig = std::move(rig.lights);
    own.default_lighting_inside = rig.inside;
  }
  lights.insert(lights.end(), own.rig.begin(), own.rig.end());
  Lighting lighting = prepare_lighting(built.world, std::move(lights));
  lighting.default_lights_added =
      own.has_default_lighting && scene.added_lighting == AddedLighting::automatic;

  copy_description(scene, built);
  own.mips = built.mips;
  stop_point();
  own.sky = stage ? stage->sky : sky_of_file(scene);
  built.stage = std::move(own);
  built.build_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return unedited_scene(*std::move(geometry), std::move(lighting), forced);
}

}  // namespace

RenderFeatures needs_of(const RenderScene& scene, const RenderSettings& settings) {
  RenderFeatures render_features = scene.render_features;
  render_features.mirrors |= settings.mirror.roughest > usual_roughest_mirror;
  const Sky* sky = scene.sky_of(settings);
  render_features.sky_picture |= sky && sky->is_picture();
  if (const BoundaryFeatures& boundaries = scene.geometry->boundaries; boundaries.known()) {
    render_features.intersections = scene.forced.intersections ||
                                    boundaries.get().counts().intersection > 0 ||
                                    !boundaries.get().intersections_complete();
  }
  return render_features;
}

SceneNotes notes_of(const RenderScene& scene) {
  SceneNotes notes = scene.geometry->notes;
  const BoundaryFeatures& boundaries = scene.geometry->boundaries;
  if (boundaries.known() && !boundaries.get().intersections_complete()) {
    notes.warnings.emplace_back(
        "too many surfaces overlap or lie close together; the lines where they pass through each "
        "other are found by samples only");
  }
  if (boundaries.failed()) notes.warnings.push_back(boundaries_error(scene).message());
  return notes;
}

std::shared_ptr<const RenderScene> assembled(RenderScene parts) {
  RenderFeatures own = parts.geometry->render_features;
  own.mirrors = needs_mirrors(parts.world(), *parts.materials);
  parts.render_features = own.with(parts.lighting->render_features).with(parts.forced);
  parts.plain =
      std::make_shared<const SimdMaterials>(parts.world(), parts.render_features, *parts.materials);
  return std::make_shared<const RenderScene>(std::move(parts));
}

std::shared_ptr<const RenderScene> unedited_scene(std::shared_ptr<const Geometry> geometry,
                                                  Lighting lighting, const RenderFeatures& forced) {
  RenderScene parts;
  parts.materials = std::make_shared<const MaterialDfrs>(dfrs_of(geometry->world));
  parts.geometry = std::move(geometry);
  parts.lighting = parts.own_lighting = std::make_shared<const Lighting>(std::move(lighting));
  parts.forced = forced;
  return assembled(std::move(parts));
}

Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene, const RenderFeatures& forced,
                                                   const AnimationInvariants* stage) {
  return prepare_on_ground(scene, forced, stage, nullptr);
}

Result<std::shared_ptr<const RenderScene>> prepare_on_ground(const Scene& scene,
                                                             const RenderFeatures& forced,
                                                             const AnimationInvariants* stage,
                                                             const ChooseGround& choose) {
  try {
    return prepare_in_memory(scene, forced, stage, choose);
  } catch (const std::bad_alloc&) {
    return unexpected(memory_error(scene.source));
  }
}

Result<std::shared_ptr<const RenderScene>> with_boundaries(
    std::shared_ptr<const RenderScene> scene) {
  if (!scene->geometry->boundaries.wait()) return unexpected(boundaries_error(*scene));
  return scene;
}

Result<std::shared_ptr<const RenderScene>> with_lights(
    const std::shared_ptr<const RenderScene>& scene, std::vector<Light> lights) {
  for (const Light& light : lights) {
    if (std::string fault = fault_of(light, scene->own_lighting->lights); !fault.empty())
      return unexpected(Error{"light '" + light.name + "'", std::move(fault)});
  }
  try {
    RenderScene relit = *scene;
    relit.exposure.reset();
    relit.lighting =
        std::make_shared<const Lighting>(prepare_lighting(scene->world(), std::move(lights)));
    return assembled(std::move(relit));
  } catch (const std::bad_alloc&) {
    return unexpected(memory_error(scene->geometry->source));
  }
}

Result<std::shared_ptr<const RenderScene>> with_dfrs(
    const std::shared_ptr<const RenderScene>& scene, MaterialDfrs dfrs) {
  const std::vector<Material>& materials = scene->world().materials;
  // Keep the ground's own ratios.
  if (dfrs.size() == materials_without_ground(scene->world())) {
    for (std::size_t i = dfrs.size(); i < materials.size(); ++i) dfrs.push_back(materials[i].dfr);
  }
  if (dfrs.size() != materials.size())
    return unexpected(Error{
        "materials", fmt::format("{} ratios for {} materials", dfrs.size(), materials.size())});
  for (std::size_t i = 0; i < dfrs.size(); ++i) {
    RenderSettings settings;
    settings.mirror.dfr = dfrs[i];
    if (const auto sound = validated(settings); !sound)
      return unexpected(Error{"material '" + materials[i].name + "'", sound.error().message()});
  }
  try {
    RenderScene edited = *scene;
    edited.exposure.reset();
    edited.materials = std::make_shared<const MaterialDfrs>(std::move(dfrs));
    return assembled(std::move(edited));
  } catch (const std::bad_alloc&) {
    return unexpected(memory_error(scene->geometry->source));
  }
}

}  // namespace asos
