#pragma once

#include "renderer/render_block.h"
#include "renderer/result.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/unfinished_block.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// How a method uses SamplingSettings::spp.
enum class SampleCount {
  none,     ///< not at all
  squares,  ///< rounded up to n * n
  any,
};

/// A rendering method: all its properties except for its own controls.
struct MethodRow {
  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  Method value = Method::asos;
  const char* name = "";   ///< on the command line, in statistics and in pictures' texts
  const char* hint = "";   ///< a few words after the name, or none
  const char* title = "";  ///< in the window
  const char* about = "";  ///< a description in whole sentences
  /// Renders the final pixels of the job's block (see render_block); may leave out causes and rays.
  BlockResult (*render)(const BlockJob& job) = nullptr;
  /// Renders the same in two stages, for interactive display; null: one stage only. Not used with
  /// coverage.
  StartedBlock (*start)(const BlockJob& job) = nullptr;
  /// See the function of that name.
  int (*block_side)(const RenderSettings& settings) = nullptr;
  /// Splits pixels' pyrays: it uses MAX, EPS and TR, and records causes.
  bool in_object_space = false;
  /// Uses the positions of boundaries (RenderScene::features), and not only ray hits.
  bool needs_boundaries = false;
  /// Refines where display differences are visible, by RenderSettings::judged_tone.
  bool judges_display = false;
  /// Uses MAX and EPS without splitting pyrays: takes samples until EPS is reached.
  bool samples_by_eps = false;
  bool takes_filter_width = false;
  bool takes_lens = true;    ///< false: its cameras are pinholes
  bool takes_motion = true;  ///< false: its pictures show one moment
  /// Its samples have times, so that it renders all moments of BlockJob::motion by itself. False:
  /// moments are rendered one by one (render_over_time).
  bool samples_time = false;
  SampleCount samples = SampleCount::none;
  /// Returns the sample placement of a method with the same number of samples in each pixel. These
  /// methods render in rounds (PixelSamples). Null for others.
  std::unique_ptr<PixelSampler> (*places)(const RenderSettings& settings) = nullptr;
  bool renders_layers = true;  ///< those that follow from surfaces
  bool takes_shapes = true;    ///< the method renders analytic shapes, too
  /// The largest scene that the method renders.
  std::size_t most_triangles = any_number;

  /// Returns whether there are scenes that the method does not support.
  [[nodiscard]] bool limited() const { return !takes_shapes || most_triangles != any_number; }
};

/// Returns the table of all methods, indexed by enumerator. A new method needs a new row, and a
/// file for the row's function.
[[nodiscard]] std::span<const MethodRow> method_table();
/// Returns the method's row of method_table.
[[nodiscard]] const MethodRow& row_of(Method method);
[[nodiscard]] inline bool in_object_space(Method method) {
  return row_of(method).in_object_space;
}

[[nodiscard]] inline bool needs_boundaries(Method method) {
  return row_of(method).needs_boundaries;
}

/// Returns the features that a picture by the settings' method needs (needs_of).
[[nodiscard]] RenderFeatures needs_of_picture(const RenderScene& scene,
                                              const RenderSettings& settings);

/// Returns the number of samples per pixel of a method that has `places`.
[[nodiscard]] int samples_a_pixel(const RenderSettings& settings);

/// Returns whether a picture has coverage: its background is transparent.
[[nodiscard]] bool shows_coverage(const RenderSettings& settings);
/// Returns the settings that render the coverage: the same boundaries and samples, without light.
[[nodiscard]] RenderSettings coverage_of(RenderSettings settings);
/// Returns whether the method renders the layers that depend on surfaces.
[[nodiscard]] inline bool renders_layers(Method method) {
  return row_of(method).renders_layers;
}
/// Whether a picture's coverage is its layer alpha. Methods that take more samples by contrast do
/// not find a dark surface before a dark background, so that their coverage is a picture of its
/// own, with samples of its own.
[[nodiscard]] inline bool covers_by_layer(Method method) {
  return in_object_space(method) || row_of(method).places;
}
/// Whether the method renders this layer. Errors: only methods in object space.
[[nodiscard]] inline bool renders_layer(Method method, Layer layer) {
  if (layer == Layer::error) return in_object_space(method);
  return !row_of(layer).of_surfaces() || renders_layers(method);
}
/// Returns the settings that render coverage with the picture, as its layer alpha.
[[nodiscard]] RenderSettings with_coverage(RenderSettings settings);
/// Makes the layer alpha the coverage of the block's pixels. If it is in `asked`, it also stays a
/// layer.
void take_coverage(LayerSet asked, BlockResult& result);
/// Adds the coverage of a block's pixels: `covered`, rendered with coverage_of.
void set_coverage(const BlockResult& covered, BlockResult& result);
/// The settings of two passes that find the contribution of unlit surfaces to pixels
/// (FinishedTile::unlit): the same boundaries and samples, without light.
struct UnlitPasses {
  explicit UnlitPasses(const RenderSettings& settings);

  RenderSettings share;
  RenderSettings colour;
};
/// Returns whether a surface that a picture may show has an unlit material.
[[nodiscard]] bool has_unlit(const World& world);
/// Adds the unlit fractions of a block's pixels from the first pass. No colour pass is needed if
/// they are all 0 or 1.
void add_unlit_share(const BlockResult& share, BlockResult& result);
[[nodiscard]] bool needs_unlit_colour(const FinishedTile& tile);
/// Adds the unlit colours from the second pass.
void add_unlit_colour(const BlockResult& colour, BlockResult& result);
/// Renders both passes and adds them to the result of `render_block`. Adds nothing if the block
/// shows no unlit surface. Statistics stay those of the pass with light.
void add_unlit(const BlockJob& job, BlockResult& result);
/// Adds the result of an earlier `add_unlit` of a block to better pixels of it. Pixels that show
/// only unlit surfaces take their new radiance.
void renew_unlit(std::vector<glm::vec4> unlit, BlockResult& result);
/// Renders a block by the row of the settings' method, over all moments of the job.
[[nodiscard]] BlockResult render_pixels(const BlockJob& job,
                                        std::span<const MethodRow> methods = method_table());
/// Fills in causes and rays that a method left out.
void fill_in(BlockResult& result);

/// Renders a block (see renderer/render_block.h) by one of these methods.
[[nodiscard]] BlockResult render_block(const BlockJob& job,
                                       std::span<const MethodRow> methods = method_table());

/// Returns the settings for a picture that is displayed by this curve: a method that judges display
/// differences uses the curve, and others are not affected. Studies do not use it: their errors are
/// those of radiance, clipped at white.
[[nodiscard]] RenderSettings judged_by(RenderSettings settings, ToneCurve curve);

/// Returns the camera that the settings' method uses: with its lens focused, or a pinhole if the
/// method does not support lenses.
[[nodiscard]] Camera viewed_camera(const RenderScene& scene, const Camera& camera,
                                   const RenderSettings& settings);

/// The picture while the shutter is open, as the settings' method shows it; none: the scene has no
/// exposure, nothing moves, or the method shows one moment. `camera` is a viewed_camera.
[[nodiscard]] std::optional<MovingPicture> moving_picture(const RenderScene& scene,
                                                          const Camera& camera,
                                                          const RenderSettings& settings);

/// Returns the side of the aligned blocks of pixels that are rendered as one piece of work.
[[nodiscard]] int block_side(const RenderSettings& settings);

/// The largest scene for beam tracing, in triangles. Each block tests every triangle, which takes
/// nearly all its time: at this size some 0.6 ms per pixel, or ten minutes of one core for
/// 1280x720.
inline constexpr std::size_t most_beam_triangles = 300'000;

/// Returns an error if the method cannot render the scene (its shapes, or its number of triangles)
/// or the layers.
[[nodiscard]] Result<void> check_method(const RenderScene& scene, const RenderSettings& settings);

}  // namespace asos
