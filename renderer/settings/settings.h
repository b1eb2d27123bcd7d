#pragma once

#include "renderer/film/layers.h"
#include "renderer/film/tone.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/background.h"
#include "renderer/settings/choices.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace asos {

class Sky;

/// The default of MirrorSettings::roughest.
inline constexpr double usual_roughest_mirror = 0.35;

/// The maximal level to which any pyray can be split.
inline constexpr int max_level_limit = 8;

/// The settings of adaptive supersampling in object space.
struct AsosSettings {
  /// MAX, 0 to max_level_limit (CGF'98 section 3.1). sobol_adaptive: 4^MAX * 4 samples at most.
  int max_level = 4;
  /// EPS, 0 to 1: allowed change of a pixel's display intensity. sobol_adaptive: standard error.
  double eps = 1.0 / 256.0;
  LeafKind leaf = LeafKind::exact;  ///< exact: cut a cell along its few boundaries (6.2, 6.4)
  StoppingRule rule = StoppingRule::unresolved;
  Detection detect = Detection::square;
  int fat = 8;                 ///< fat pyrays are fat x fat pixels: 2, 4, 8 or 16 (6.4)
  bool refine_shading = true;  ///< also split for varying shading
  bool jitter = false;         ///< jitter the samples of leaves that stay marginal at MAX

  bool operator==(const AsosSettings&) const = default;
};

/// The settings of sampling methods.
struct SamplingSettings {
  static constexpr double max_contrast_scale = 4.0;  // above 10/3 no contrast reaches a threshold

  /// sobol: samples per pixel; uniform and stochastic: rounded up to n * n. mitchell: samples in
  /// pixels of high contrast. ray_bound: samples in pixels with a boundary, rounded up to n * n.
  int spp = 16;
  double contrast = 0.05;  ///< whitted: allowed difference of corners, 0 to 1 in display intensity
  int depth = 3;           ///< whitted: maximal level of squares, 0 to 8
  bool spheres = false;    ///< whitted: with enlarged bounding spheres around small objects
  double contrast_scale = 1.0;  ///< mitchell: of the thresholds 0.4, 0.3, 0.6; 0 to 4, 0: always

  bool operator==(const SamplingSettings&) const = default;
};

struct TextureSettings {
  static constexpr int max_resolution = 8;

  TextureFilter filter = TextureFilter::footprint;
  /// TR, 1 to 8: asos takes TR x TR jittered samples of a pixel that shows a textured surface
  /// without boundaries, and proportionally fewer in a part of a pixel (CGF'98 section 3.2).
  int resolution = 1;

  bool operator==(const TextureSettings&) const = default;
};

struct ShadowSettings {
  bool cast = true;  ///< lights cast shadows
  /// The sky's light is shadowed, too. Otherwise, or without shadows, the sky is not occluded, and
  /// its light is reduced by a fixed visibility (sky_visibility, mirrored_visibility).
  bool sky = false;
  /// The number of diffuse light bounces between surfaces, 0 or 1; only with shadows. With a
  /// bounce, surfaces that occlude the sky also send light, so that the sky is shadowed, too.
  int bounces = 0;
  ShadowQuality quality = ShadowQuality::refined;
  int divisions = 2;  ///< n of the qualities that divide a patch into n x n parts, 1 to 16
  LightRule light_rule = LightRule::physical;

  [[nodiscard]] bool follows_bounces() const { return cast && bounces > 0; }
  [[nodiscard]] bool shades_sky() const { return cast && (sky || bounces > 0); }

  bool operator==(const ShadowSettings&) const = default;
};

struct MirrorSettings {
  static constexpr int max_bounces = 64;

  int bounces = 4;  ///< maximal number of successive mirror reflections, 0 to 64
  /// The roughness, 0 to 1, up to which surfaces show reflections. Rougher ones show the sky's mean
  /// and the highlights of lights.
  double roughest = usual_roughest_mirror;
  /// Defocusing ratio of all mirrors, instead of their materials'.
  std::optional<Dfr> dfr;
  CurvedMirror curved = CurvedMirror::approximate;
  /// Maximal angle of a pyray reflected by a curved shape. For a mesh an eighth of it, since
  /// triangles do not define the curvature.
  double widest_angle_deg = 10.0;

  bool operator==(const MirrorSettings&) const = default;
};

/// How long a picture is exposed around its moment of an animation.
struct ShutterSettings {
  static constexpr double longest = 3600.0;

  double seconds = 0.0;  ///< 0 to `longest`; 0: the picture shows one moment
  /// Index of the scene's camera whose motion the picture's camera follows; -1: it stands still.
  int camera = -1;

  [[nodiscard]] bool blurs() const { return seconds > 0.0; }
  bool operator==(const ShutterSettings&) const = default;
};

/// The settings of a rendering, with defaults. Widgets and renderers work on copies. `validated`
/// returns an error for values out of range; nothing is clamped silently.
struct RenderSettings {
  static constexpr double max_filter_width = 4.0;
  static constexpr double max_line_width = 16.0;

  int width = 1280;  ///< pixels, 1 to 32768
  int height = 720;
  PixelRect crop;  ///< part of the picture to render; empty: all. Equals that part of the whole
  Method method = Method::asos;
  /// Side, in pixels, of the square over which a pixel is averaged, 1 to 4 (CGF'98 section 3). Only
  /// for methods with MethodRow::takes_filter_width; for others it is 1.
  double filter_width = 1.0;
  /// Width of lines and diameter of points, in pixels, 0 (hidden) to 16.
  double line_width = 1.0;
  /// The curve that displays the picture, for methods that judge differences in display values
  /// (EPS, contrast): see judged_by. The exposure has no effect.
  ToneCurve judged_tone = ToneCurve::none;
  AsosSettings asos;
  SamplingSettings sampling;
  TextureSettings texture;
  ShadowSettings shadow;
  MirrorSettings mirror;
  ShutterSettings shutter;
  std::shared_ptr<const Sky> sky;  ///< the surroundings of the scene; null: neutral grey
  Background background;           ///< the visible background
  Ground ground = Ground::off;     ///< see with_ground
  LayerSet layers;                 ///< rendered with the picture, whose bits they do not change
  bool cull = true;  ///< the backs of single-sided materials are not seen, as glTF says
  int seed = 0;      ///< of the scrambling of Sobol samples, from 0; it changes the noise
  int threads = 0;   ///< workers; 0: one per core

  bool operator==(const RenderSettings&) const = default;

  /// Returns the rendered pixels: the crop, or the whole picture.
  [[nodiscard]] PixelRect visible() const {
    return crop == PixelRect{} ? PixelRect{0, 0, width, height} : crop;
  }
};

/// Returns the effective settings of asos: for asos_published, those with the published choices of
/// the papers.
[[nodiscard]] RenderSettings as_published(RenderSettings settings);

/// Side of the aligned blocks of pixels in which most methods work: see block_side.
inline constexpr int block_size = 8;

/// Returns the settings unchanged, or an error for the first one out of range. The error's subject
/// is the setting's name on the command line.
[[nodiscard]] Result<RenderSettings> validated(const RenderSettings& settings);

}  // namespace asos
