#pragma once

#include "renderer/settings/choices.h"
#include "renderer/settings/settings.h"
#include "renderer/world/world.h"

#include <span>
#include <string>
#include <vector>

namespace asos {

/// The features that a scene needs (design section 8). Those that it does not need cost nothing. A
/// default one needs nothing.
struct SceneNeeds {
  bool textures = false;
  bool mip_chains = false;
  bool unused_images = false;  ///< true as well where the file brings none along
  bool normal_maps = false;
  bool vertex_colors = false;
  bool alpha_mask = false;
  bool alpha_blend = false;  ///< transmission, too
  /// An opacity that differs from place to place. It says how shadows are looked for, not only
  /// whether: where it is not so, forcing it would give another picture.
  bool varying_opacity = false;
  bool culling = false;  ///< of the backs of single-sided materials
  bool metals = false;
  bool mirrors = false;  ///< up to usual_roughest_mirror, or with defocusing ratios of their own
  bool shapes = false;   ///< analytic ones
  bool emission = false;
  bool punctual_lights = false;   ///< of no size: point, spot, directional
  bool rectangle_lights = false;  ///< and polygons
  bool disk_lights = false;
  bool ball_lights = false;
  bool linear_lights = false;
  bool suns = false;
  bool shadows = false;       ///< some light casts them
  bool soft_shadows = false;  ///< some light of a size casts them
  bool intersections = false;
  /// A picture of what surrounds the scene, which no scene has: it comes with the settings.
  bool sky_picture = false;

  /// All that can be asked for without need and without changing the picture: all but
  /// varying_opacity and sky_picture.
  [[nodiscard]] static SceneNeeds all();

  /// Whether there is any light, of whatever kind.
  [[nodiscard]] bool lights() const {
    return punctual_lights || rectangle_lights || disk_lights || ball_lights || linear_lights ||
           suns;
  }

  /// The features that either of the two needs.
  [[nodiscard]] SceneNeeds with(const SceneNeeds& other) const;

  /// The features that were left out, with the reason and the saving, in a sentence each.
  [[nodiscard]] std::vector<std::string> left_out() const;

  bool operator==(const SceneNeeds&) const = default;
};

[[nodiscard]] inline SceneNeeds forced_by(NeedsChoice choice) {
  return choice == NeedsChoice::all ? SceneNeeds::all() : SceneNeeds{};
}

/// One of SceneNeeds' features in words. The last four name what is left out with it and are empty
/// where there is nothing of that sort.
struct SceneFeature {
  bool SceneNeeds::*needed;
  const char* name;
  const char* reason;  ///< why it can be left out
  const char* stages;
  const char* memory;
  const char* controls;
  const char* rows;
};

/// Each member of SceneNeeds once.
[[nodiscard]] std::span<const SceneFeature> scene_features();

/// The features that were left out.
[[nodiscard]] std::vector<SceneFeature> features_left_out(const SceneNeeds& needs);

/// The features that the surfaces of `world` and their materials need. `intersections` is true:
/// whether surfaces pass through each other is known only once FeatureSet has looked.
[[nodiscard]] SceneNeeds find_needs(const World& world);

/// Whether the opacity of a part that is not opaque may differ from place to place.
[[nodiscard]] bool opacity_varies(const World& world, const Part& part);

/// The features that lights need beyond those.
[[nodiscard]] SceneNeeds find_needs(std::span<const Light> lights);

/// SceneNeeds::mirrors where the materials have these defocusing ratios instead of their own.
[[nodiscard]] bool needs_mirrors(const World& world, const MaterialDfrs& dfrs);

/// Releases the texels of images that no shown material names.
void release_unused_images(World& world);

/// Fills the vertices' arrays that `forced` asks for and no material needs, with what changes
/// nothing: white, no tangent, the texture's corner.
void fill_forced_attributes(World& world, const SceneNeeds& forced);

}  // namespace asos
