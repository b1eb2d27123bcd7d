#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/methods/settings.h"
#include "renderer/methods/whitted_spheres.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/result.h"
#include "renderer/scene/needs.h"
#include "renderer/scene/world.h"
#include "renderer/shading/shade.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace asos {

/// A scene made ready to render: flattened, with its rays' and its boundaries' hierarchies.
/// Immutable once built, shared by all workers; `rays` points into `world`, so it never moves.
struct RenderScene {
  World world;
  SceneNeeds needs;          ///< those of the world, and what was forced
  bool default_rig = false;  ///< next to no light came from the scene: `world.lights` ends in a rig
  std::size_t emissive_lights = 0;  ///< lights in `world.lights` that stand for emissive meshes
  RayScene rays;
  FeatureSet features;
  MipChains mips;
  LightCuts light_cuts;  ///< of `world.lights`
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

/// The shader of a scene's picture, as the settings ask.
[[nodiscard]] inline Shader shader_of(const RenderScene& scene, const RenderSettings& settings,
                                      const View& view) {
  const bool filtered = settings.texture_filter == TextureFilter::footprint;
  return Shader(scene.world, scene.needs, scene.rays,
                {settings.shadows, settings.light_rule, seen_faces(settings),
                 filtered ? &scene.mips : nullptr, PixelSpacing::of(view), &scene.light_cuts});
}

/// Flattens and indexes `scene` and lights it: by its own lights, its emissive meshes, and a rig
/// where neither shines to speak of.
/// `forced`: what is kept and done although the scene does not need it, to test and to measure what
/// leaving it out does; it does not change the picture.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene,
                                                                 const SceneNeeds& forced = {});

}  // namespace asos
