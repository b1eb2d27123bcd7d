#pragma once

#include "renderer/lights/lighting.h"
#include "renderer/prepared/geometry.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/simd_materials.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos {

struct Exposure;

/// A scene made ready to render, of three parts that are immutable, shared, and replaced one at a
/// time: editing a light or a material costs what that part costs. A small value; `assembled`
/// derives its features and its compact materials from the parts.
struct RenderScene {
  std::shared_ptr<const Geometry> geometry;
  std::shared_ptr<const MaterialDfrs> materials;  ///< defocusing ratios of materials; editable
  std::shared_ptr<const Lighting> lighting;
  std::shared_ptr<const Lighting> own_lighting;  ///< as the scene was prepared, before any edit
  std::shared_ptr<const SimdMaterials> plain;    ///< compact materials for batches of points
  RenderFeatures forced;                         ///< see prepare
  RenderFeatures render_features;                ///< features of all parts, and the forced ones
  /// The scene while the shutter is open (`exposed`). Null: not made; edits of the scene drop it.
  std::shared_ptr<const Exposure> exposure;

  [[nodiscard]] const World& world() const { return geometry->world; }
  [[nodiscard]] const RayScene& rays() const { return geometry->rays; }
  /// Waits until the boundaries are known: see BoundaryFeatures.
  [[nodiscard]] const FeatureSet& features() const { return geometry->boundaries.get(); }
  [[nodiscard]] const MipChains& mips() const { return geometry->mips; }
  [[nodiscard]] const std::vector<Light>& lights() const { return lighting->lights; }
  [[nodiscard]] const MaterialDfrs& dfrs() const { return *materials; }
  /// Returns the surroundings in a picture of the scene: those in the settings, or the file's own;
  /// null: the neutral sky.
  [[nodiscard]] const Sky* sky_of(const RenderSettings& settings) const {
    return settings.sky ? settings.sky.get() : geometry->stage.sky.get();
  }
  /// Returns the defocusing ratios of a surface's material, if it has its own.
  [[nodiscard]] const std::optional<Dfr>& dfr_of(std::uint32_t triangle) const {
    return (*materials)[geometry->world.material_index(triangle)];
  }
};

/// Makes a scene from these parts and derives its features. All parts must be set.
[[nodiscard]] std::shared_ptr<const RenderScene> assembled(RenderScene parts);

/// Makes a scene from these parts, with its materials' own defocusing ratios.
[[nodiscard]] std::shared_ptr<const RenderScene> unedited_scene(
    std::shared_ptr<const Geometry> geometry, Lighting lighting, const RenderFeatures& forced = {});

[[nodiscard]] inline Culling culling_of(const RenderSettings& settings) {
  return settings.cull ? Culling::as_material_says : Culling::none;
}

/// Returns the features that a picture of the scene needs with these settings. The settings may
/// need more than the scene. Known boundaries may show that less is needed. Whether boundaries are
/// needed depends on the method: see needs_of_picture.
[[nodiscard]] RenderFeatures needs_of(const RenderScene& scene, const RenderSettings& settings);

/// Returns the shader for a picture of the scene with these settings; `bend` is that of
/// ShadingSettings.
[[nodiscard]] inline Shader shader_of(const RenderScene& scene, const RenderSettings& settings,
                                      const View& view, float bend = 1.0f) {
  const bool filtered = settings.texture.filter == TextureFilter::footprint;
  const bool mirrors = needs_of(scene, settings).mirrors;
  return Shader(
      scene.world(), scene.render_features, scene.rays(), *scene.lighting,
      {settings.shadow.cast, settings.shadow.shades_sky(), settings.shadow.follows_bounces(),
       settings.shadow.light_rule, culling_of(settings), filtered ? &scene.mips() : nullptr,
       PixelSpacing::of(view), scene.sky_of(settings), mirrors ? settings.mirror.bounces : 0,
       static_cast<float>(settings.mirror.roughest),
       settings.mirror.dfr ? &*settings.mirror.dfr : nullptr, &scene.dfrs(), bend,
       BackgroundRadiance(settings.background, view)});
}

/// Returns the notes for the user: on the scene's file, and on its boundaries as soon as they are
/// known.
[[nodiscard]] SceneNotes notes_of(const RenderScene& scene);

/// Flattens and indexes `scene`, and lights it by its own lights, its emissive meshes, and default
/// lights if both are negligible. The search for its boundaries begins on demand.
/// - `forced`: features that are kept although the scene does not need them, for tests and
///   measurements. They do not change the picture.
/// - `stage`: that of the same scene at rest, if `scene` is at another time; null: its own.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> prepare(
    const Scene& scene, const RenderFeatures& forced = {},
    const AnimationInvariants* stage = nullptr);

/// Returns the same scene, once its boundaries are known. Errors: lack of memory for them.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_boundaries(
    std::shared_ptr<const RenderScene> scene);

/// Returns the same scene with `lights` (relative to World::origin) instead of its own. Shares
/// geometry and materials with `scene`. Errors: a light that is not finite, and one whose own part
/// belongs to no light of the prepared scene.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_lights(
    const std::shared_ptr<const RenderScene>& scene, std::vector<Light> lights);

/// Returns the same scene with these defocusing ratios instead of its materials' own. Shares
/// geometry and lighting with `scene`. Materials that look alike (same_look) should stay so, since
/// there is no boundary between them. Errors: not one entry for each material, a ratio out of
/// range.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_dfrs(
    const std::shared_ptr<const RenderScene>& scene, MaterialDfrs dfrs);

}  // namespace asos
