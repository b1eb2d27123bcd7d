#include "renderer/prepared/with_images.h"

#include "renderer/prepared/own_lights.h"
#include "renderer/prepared/rebuilt_geometry.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/ground.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace asos {
namespace {

/// Poses another rig's scene and gives it these images.
class RigWithImages : public PosableScene, public std::enable_shared_from_this<RigWithImages> {
 public:
  RigWithImages(std::shared_ptr<PosableScene> plain, std::vector<Image> images)
      : plain_(std::move(plain)), images_(std::move(images)) {}

  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    Result<Scene> scene = plain_->pose(time);
    if (!scene) return scene;
    scene->images = images_;
    scene->rig = shared_from_this();
    return scene;
  }

 private:
  std::shared_ptr<PosableScene> plain_;
  std::vector<Image> images_;
};

/// Puts the warnings about images in front, where they are when a file is read at once. Warnings
/// in both lists are kept once.
std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& others) {
  const std::vector<std::string> known = first;
  for (const std::string& warning : others)
    if (std::find(known.begin(), known.end(), warning) == known.end()) first.push_back(warning);
  return first;
}

bool has_holes(const World& world) {
  return std::any_of(world.parts.begin(), world.parts.end(), [&](const Part& part) {
    return surface_kind(world.materials[part.material]) == SurfaceKind::masked;
  });
}

/// Returns the lights with the default ones for the geometry; none: they stay.
std::optional<std::vector<Light>> lights_of(const RenderScene& before, Geometry& geometry) {
  AnimationInvariants& stage = geometry.stage;
  const bool at_rest = !geometry.time && stage.whole.empty();
  if (!stage.has_default_lighting || !at_rest || !has_holes(geometry.world)) return std::nullopt;
  DefaultLighting now =
      default_lighting(geometry.world, bounds_without_ground(geometry.world), geometry.rays);
  stage.default_lighting_inside = now.inside;
  if (stage.rig.empty() || now.lights == stage.rig) return std::nullopt;
  std::vector<Light> lights = before.own_lighting->lights;
  lights.resize(lights.size() - stage.rig.size());  // they come last
  lights.insert(lights.end(), now.lights.begin(), now.lights.end());
  stage.rig = std::move(now.lights);
  return lights;
}

Result<std::shared_ptr<const RenderScene>> in_memory(const RenderScene& prepared,
                                                     const Scene& scene) {
  World world = prepared.world();
  world.images = scene.images;
  auto geometry = rebuilt_geometry(prepared, std::move(world), prepared.own_lighting->lights);
  if (!geometry) return unexpected(geometry.error());
  Geometry& built = **geometry;
  built.notes.warnings = joined(scene.notes.warnings, built.notes.warnings);
  built.stage.mips = built.mips;
  if (built.rig) built.rig = std::make_shared<RigWithImages>(built.rig, scene.images);
  RenderScene with = prepared;
  with.exposure.reset();
  if (auto lights = lights_of(prepared, built)) {
    Lighting lighting = prepare_lighting(built.world, *std::move(lights));
    lighting.default_lights_added = prepared.own_lighting->default_lights_added;
    with.lighting = with.own_lighting = std::make_shared<const Lighting>(std::move(lighting));
  }
  with.geometry = *std::move(geometry);
  return assembled(std::move(with));
}

}  // namespace

bool has_images_for(const Scene& scene, const RenderScene& prepared) {
  const World& world = prepared.world();
  const auto same = [](const Texture& a, const Texture& b) {
    return a.image == b.image && a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v &&
           a.filter == b.filter;
  };
  return scene.images.size() == world.images.size() &&
         std::equal(scene.textures.begin(), scene.textures.end(), world.textures.begin(),
                    world.textures.end(), same);
}

Result<std::shared_ptr<const RenderScene>> with_images(
    const std::shared_ptr<const RenderScene>& prepared, const Scene& scene) {
  try {
    return in_memory(*prepared, scene);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{prepared->geometry->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
