#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/shade.h"
#include "renderer/world/needs.h"
#include "renderer/world/object_spheres.h"
#include "renderer/world/world.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace asos {

/// What of a scene takes long to build and does not depend on its lights.
struct SceneIndex {
  RayScene rays;
  FeatureSet features;
  MipChains mips;
};

/// A scene made ready to render: flattened, with its rays' and its boundaries' hierarchies.
/// Immutable once built, shared by all workers; `rays` points into a world, so it never moves.
/// A copy shares the hierarchies.
struct RenderScene {
  World world;
  SceneNeeds needs;          ///< those of the world, and what was forced
  bool default_rig = false;  ///< next to no light came from the scene: `world.lights` ends in a rig
  std::size_t emissive_lights = 0;  ///< lights in `world.lights` that stand for emissive meshes
  SceneNeeds forced;                ///< see prepare
  std::shared_ptr<SceneIndex> index = std::make_shared<SceneIndex>();
  const RayScene& rays = index->rays;
  const FeatureSet& features = index->features;
  const MipChains& mips = index->mips;
  /// The scene that the index was built for, whose world `rays` points into; null: this one.
  std::shared_ptr<const RenderScene> built_from;
  LightCuts light_cuts;  ///< of `world.lights`
  BareLights bare_lights;
  std::vector<ObjectSphere> object_spheres;
  SceneNotes notes;
  std::string name;
  std::string source;
  double build_seconds = 0.0;
  double memory_mb = 0.0;  ///< of geometry, textures with their mip chains, and both hierarchies
};

[[nodiscard]] inline Faces seen_faces(const RenderSettings& settings) {
  return settings.cull ? Faces::as_material_says : Faces::all;
}

/// What a picture of the scene with these settings needs: more than the scene where the settings
/// ask for it.
[[nodiscard]] SceneNeeds needs_of(const RenderScene& scene, const RenderSettings& settings);

/// The shader of a scene's picture, as the settings ask.
[[nodiscard]] inline Shader shader_of(const RenderScene& scene, const RenderSettings& settings,
                                      const View& view) {
  const bool filtered = settings.texture.filter == TextureFilter::footprint;
  const bool mirrors = needs_of(scene, settings).mirrors;
  return Shader(scene.world, scene.needs, scene.rays,
                {settings.shadow.cast, settings.shadow.light_rule, seen_faces(settings),
                 filtered ? &scene.mips : nullptr, PixelSpacing::of(view), &scene.light_cuts,
                 settings.sky.get(), &scene.bare_lights, mirrors ? settings.mirror.bounces : 0,
                 static_cast<float>(settings.mirror.roughest),
                 settings.mirror.dfr ? &*settings.mirror.dfr : nullptr});
}

/// Flattens and indexes `scene` and lights it: by its own lights, its emissive meshes, and a rig
/// where neither shines to speak of.
/// `forced`: what is kept and done although the scene does not need it, to test and to measure what
/// leaving it out does; it does not change the picture.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene,
                                                                 const SceneNeeds& forced = {});

/// The same scene in the light of `lights` (relative to World::origin) instead of its own. Shares
/// the hierarchies with `scene` and keeps it alive; copies its world, so that this takes time for
/// each triangle and texel, but builds nothing. Errors: a light that is not finite, and one whose
/// own part is none of a light of the scene that was prepared.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_lights(
    const std::shared_ptr<const RenderScene>& scene, std::vector<Light> lights);

}  // namespace asos
