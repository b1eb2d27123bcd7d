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

/// MirrorSettings::roughest, unless another is asked for.
inline constexpr double usual_roughest_mirror = 0.35;

/// The deepest level that any pyray may be split to.
inline constexpr int max_level_limit = 8;

/// Adaptive supersampling in object space.
struct AsosSettings {
  /// MAX, 0 to max_level_limit (CGF'98 section 3.1). sobol_adaptive: 4^MAX * 4 samples at most.
  int max_level = 4;
  /// EPS, 0 to 1: allowed change of a pixel's display intensity. sobol_adaptive: standard error.
  double eps = 1.0 / 256.0;
  LeafKind leaf = LeafKind::exact;  ///< exact: cut a cell along its few boundaries (6.2, 6.4)
  StoppingRule rule = StoppingRule::unresolved;
  Detection detect = Detection::square;
  int fat = 8;                 ///< fat pyrays are fat x fat pixels: 2, 4, 8 or 16 (6.4)
  bool refine_shading = true;  ///< split what is shaded unevenly, too
  bool jitter = false;         ///< jitter the samples of leaves that stay marginal at MAX

  bool operator==(const AsosSettings&) const = default;
};

/// The methods that take samples of pixels.
struct SamplingSettings {
  static constexpr double max_contrast_scale = 4.0;  // beyond 10/3 nothing reaches a threshold

  /// sobol: samples a pixel; uniform and stochastic: rounded up to n * n. mitchell: samples where
  /// the contrast is high. ray_bound: where a boundary is, rounded up to n * n.
  int spp = 16;
  double contrast = 0.05;  ///< whitted: by how much corners may differ, 0 to 1 of display intensity
  int depth = 3;           ///< whitted: the deepest level that squares are split to, 0 to 8
  bool spheres = false;    ///< whitted: with enlarged bounding spheres around small objects
  double contrast_scale = 1.0;  ///< mitchell: of the thresholds 0.4, 0.3, 0.6; 0 to 4, 0: always

  bool operator==(const SamplingSettings&) const = default;
};

struct TextureSettings {
  static constexpr int max_resolution = 8;

  TextureFilter filter = TextureFilter::footprint;
  /// TR, 1 to 8: asos takes TR x TR jittered samples of a pixel of textured surface that nothing
  /// bounds, and accordingly fewer of a part of one (CGF'98 section 3.2).
  int resolution = 1;

  bool operator==(const TextureSettings&) const = default;
};

struct ShadowSettings {
  bool cast = true;  ///< lights cast shadows
  /// The sky's light is shaded, too; else, or where lights cast none, it is open, less a share
  /// (sky_visibility, mirrored_visibility).
  bool sky = false;
  /// Diffuse bounces of light between surfaces that are followed, 0 or 1, where lights cast
  /// shadows: what hides the sky from a surface sends it light then, so that the sky is shaded,
  /// too.
  int bounces = 0;
  ShadowQuality quality = ShadowQuality::refined;
  int divisions = 2;  ///< n of the qualities that divide a patch into n x n, 1 to 16
  LightRule light_rule = LightRule::physical;

  [[nodiscard]] bool follows_bounces() const { return cast && bounces > 0; }
  [[nodiscard]] bool shades_sky() const { return cast && (sky || bounces > 0); }

  bool operator==(const ShadowSettings&) const = default;
};

struct MirrorSettings {
  static constexpr int max_bounces = 64;

  int bounces = 4;  ///< that mirror-like surfaces are followed for, 0 to 64
  /// Rougher surfaces show the sky's mean and lights' highlights instead of what they reflect, 0
  /// to 1.
  double roughest = usual_roughest_mirror;
  /// How all that mirrors blurs, instead of what its material says.
  std::optional<Dfr> dfr;
  CurvedMirror curved = CurvedMirror::approximate;
  /// That a pyray may span which a curved shape reflects; an eighth of it where that is a mesh,
  /// whose triangles do not tell how it is bent.
  double widest_angle_deg = 10.0;

  bool operator==(const MirrorSettings&) const = default;
};

/// The settings of a rendering. Defaulted and comparable; widgets edit a copy, work takes a copy.
/// `validated` says what is out of range; nothing is clamped silently.
struct RenderSettings {
  static constexpr double max_filter_width = 4.0;
  static constexpr double max_line_width = 16.0;

  int width = 1280;  ///< pixels, 1 to 32768
  int height = 720;
  PixelRect crop;  ///< part of the picture to render; empty: all. Equals that part of the whole
  Method method = Method::asos;
  /// Side, in pixels, of the square around its middle that a pixel is the mean of, 1 to 4 (CGF'98
  /// section 3); for the methods whose row says so (MethodRow), for the others pixels are 1 wide.
  double filter_width = 1.0;
  /// Of lines, and the diameter of points, in pixels, 0 (they are left out) to 16.
  double line_width = 1.0;
  /// The curve that the picture is shown by, where differences are judged as they show (EPS, and
  /// contrasts): see judged_by. Exposure is no part of it.
  ToneCurve judged_tone = ToneCurve::none;
  AsosSettings asos;
  SamplingSettings sampling;
  TextureSettings texture;
  ShadowSettings shadow;
  MirrorSettings mirror;
  std::shared_ptr<const Sky> sky;  ///< the surroundings of the scene; null: neutral grey
  Background background;           ///< what the eye sees of them
  Ground ground = Ground::off;     ///< see with_ground
  LayerSet layers;                 ///< rendered with the picture, whose bits they do not change
  bool cull = true;  ///< the backs of single-sided materials are not seen, as glTF says
  int seed = 0;      ///< of the scrambling of Sobol samples, from 0; another one: other noise
  int threads = 0;   ///< workers; 0: as many as the machine has cores for

  bool operator==(const RenderSettings&) const = default;

  /// The pixels that are rendered: the crop, or all of the picture.
  [[nodiscard]] PixelRect visible() const {
    return crop == PixelRect{} ? PixelRect{0, 0, width, height} : crop;
  }
};

/// The settings that asos really renders with: for asos_published, those with the published choices
/// of the papers.
[[nodiscard]] RenderSettings as_published(RenderSettings settings);

/// Side of the aligned blocks of pixels that most methods work in: see block_side.
inline constexpr int block_size = 8;

/// The settings as they are, or what is wrong with the first one that is out of range; the error's
/// subject is the setting's name on the command line.
[[nodiscard]] Result<RenderSettings> validated(const RenderSettings& settings);

}  // namespace asos
