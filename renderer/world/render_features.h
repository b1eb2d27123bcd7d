#pragma once

#include "renderer/settings/choices.h"
#include "renderer/settings/settings.h"
#include "renderer/world/world.h"

#include <span>
#include <string>
#include <vector>

namespace asos {

/// The features that a scene needs (design section 8). Unneeded features cost nothing. The default
/// is none.
struct RenderFeatures {
  bool textures = false;
  bool mip_chains = false;
  bool unused_images = false;  ///< false: there are some, which are released
  bool normal_maps = false;
  bool vertex_colors = false;
  bool alpha_mask = false;
  bool alpha_blend = false;  ///< includes transmission
  /// Opacity that varies over a surface. It changes how shadows are computed, not only whether, so
  /// forcing it would change the picture.
  bool varying_opacity = false;
  bool culling = false;  ///< of the backs of single-sided materials
  bool metals = false;
  bool mirrors = false;  ///< up to usual_roughest_mirror, or with their own defocusing ratios
  bool shapes = false;   ///< analytic ones
  bool emission = false;
  bool punctual_lights = false;   ///< without extent: point, spot, directional
  bool rectangle_lights = false;  ///< and polygons
  bool disk_lights = false;
  bool ball_lights = false;
  bool linear_lights = false;
  bool suns = false;
  bool shadows = false;       ///< some light casts them
  bool soft_shadows = false;  ///< a light with an extent casts them
  bool boundaries = false;    ///< depends on the method
  bool intersections = false;
  /// An environment picture. No scene needs it; it comes with the settings.
  bool sky_picture = false;

  /// Returns all features that can be forced without changing the picture: all but varying_opacity
  /// and sky_picture.
  [[nodiscard]] static RenderFeatures all();

  /// Returns whether there are lights of any kind.
  [[nodiscard]] bool lights() const {
    return punctual_lights || rectangle_lights || disk_lights || ball_lights || linear_lights ||
           suns;
  }

  /// Returns the features that at least one of the two needs.
  [[nodiscard]] RenderFeatures with(const RenderFeatures& other) const;

  /// Returns the unneeded features, with the reason and the saving, in one sentence each.
  [[nodiscard]] std::vector<std::string> left_out() const;

  bool operator==(const RenderFeatures&) const = default;
};

[[nodiscard]] inline RenderFeatures forced_by(FeatureChoice choice) {
  return choice == FeatureChoice::all ? RenderFeatures::all() : RenderFeatures{};
}

/// Describes one of RenderFeatures' members. The last four strings name the savings without the
/// feature; empty: none.
struct RenderFeature {
  bool RenderFeatures::*needed;
  const char* name;
  const char* reason;  ///< why it is not needed
  const char* stages;
  const char* memory;
  const char* controls;
  const char* rows;
};

/// Returns the descriptions of all members of RenderFeatures.
[[nodiscard]] std::span<const RenderFeature> render_feature_list();

/// Returns the unneeded features.
[[nodiscard]] std::vector<RenderFeature> features_left_out(const RenderFeatures& render_features);

/// Returns the features that the surfaces of `world` and their materials need. `boundaries` and
/// `intersections` are true: the former depends on the method, and only FeatureSet finds out
/// whether surfaces pass through each other.
[[nodiscard]] RenderFeatures find_render_features(const World& world);

/// Returns whether the opacity of a non-opaque part may vary.
[[nodiscard]] bool opacity_varies(const World& world, const Part& part);

/// Returns RenderFeatures::mirrors for materials with these defocusing ratios instead of their own.
[[nodiscard]] bool needs_mirrors(const World& world, const MaterialDfrs& dfrs);

/// Releases the texels of images that no visible material uses.
void release_unused_images(World& world);

/// Fills the vertices' arrays that are forced but not needed with neutral values: white, no
/// tangent, the texture's corner.
void fill_forced_attributes(World& world, const RenderFeatures& forced);

}  // namespace asos
