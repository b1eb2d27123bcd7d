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
#include <span>
#include <vector>

namespace asos {

/// How a method reads SamplingSettings::spp.
enum class SampleCount {
  none,     ///< not at all
  squares,  ///< rounded up to n * n
  any,
};

/// A method of rendering: all that the program knows of it but for controls of its own.
struct MethodRow {
  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  Method value = Method::asos;
  const char* name = "";   ///< on the command line, in statistics and in pictures' texts
  const char* hint = "";   ///< a few words behind the name, or none
  const char* title = "";  ///< in the window
  const char* about = "";  ///< in whole sentences
  /// The final pixels of the job's block, as render_block promises them; causes and rays may be
  /// left out.
  BlockResult (*render)(const BlockJob& job) = nullptr;
  /// The same in two stages, for who looks on; null: it has one. Not with coverage.
  StartedBlock (*start)(const BlockJob& job) = nullptr;
  /// See the function of that name.
  int (*block_side)(const RenderSettings& settings) = nullptr;
  /// It splits pixels' pyrays: MAX, EPS and TR are for it, and it tells causes.
  bool in_object_space = false;
  /// It asks where boundaries are (RenderScene::features), and not only what rays meet.
  bool needs_boundaries = false;
  /// It goes on where differences show, by RenderSettings::judged_tone.
  bool judges_display = false;
  /// Without splitting pyrays it takes samples by MAX and EPS: more until EPS is met.
  bool samples_by_eps = false;
  bool takes_filter_width = false;
  bool takes_lens = true;  ///< else its cameras are pinholes
  SampleCount samples = SampleCount::none;
  /// Where it places the samples of each pixel, all of which have as many: such a method renders in
  /// rounds (PixelSamples). Null for others.
  std::unique_ptr<SamplePlaces> (*places)(const RenderSettings& settings) = nullptr;
  bool takes_shapes = true;  ///< it renders analytic shapes, too
  /// The largest scene that it renders.
  std::size_t most_triangles = any_number;

  /// Whether there are scenes that it does not take.
  [[nodiscard]] bool limited() const { return !takes_shapes || most_triangles != any_number; }
};

/// All methods, each at the place of its enumerator. Another one is another row of it, and the file
/// of the row's function.
[[nodiscard]] std::span<const MethodRow> method_table();
/// The method's row there.
[[nodiscard]] const MethodRow& row_of(Method method);
[[nodiscard]] inline bool in_object_space(Method method) {
  return row_of(method).in_object_space;
}

[[nodiscard]] inline bool needs_boundaries(Method method) {
  return row_of(method).needs_boundaries;
}

/// The samples of each pixel of a method that has `places`.
[[nodiscard]] int samples_a_pixel(const RenderSettings& settings);

/// Whether a picture tells how much of its pixels surfaces cover: where its background is
/// transparent.
[[nodiscard]] bool shows_coverage(const RenderSettings& settings);
/// The settings that render this coverage: the same boundaries and samples, without light.
[[nodiscard]] RenderSettings coverage_of(RenderSettings settings);
/// Whether the method renders the layers that follow from surfaces.
[[nodiscard]] inline bool renders_layers(Method method) {
  return in_object_space(method) || row_of(method).places;
}
/// Whether it renders this one: ASOS alone estimates its error.
[[nodiscard]] inline bool renders_layer(Method method, Layer layer) {
  if (layer == Layer::error) return in_object_space(method);
  return !row_of(layer).of_surfaces() || renders_layers(method);
}
/// The settings that render coverage along with the picture, as its layer alpha.
[[nodiscard]] RenderSettings with_coverage(RenderSettings settings);
/// Makes that layer the coverage of the block's pixels; it stays a layer where it is `asked` for.
void take_coverage(LayerSet asked, BlockResult& result);
/// Adds the coverage of a block's pixels that was rendered by these settings.
void set_coverage(const BlockResult& covered, BlockResult& result);
/// The settings of two passes that find what unlit surfaces show of pixels (FinishedTile::unlit):
/// the same boundaries and samples, without light.
struct UnlitPasses {
  explicit UnlitPasses(const RenderSettings& settings);

  RenderSettings share;
  RenderSettings colour;
};
/// Whether a surface that a picture may show has an unlit material.
[[nodiscard]] bool has_unlit(const World& world);
/// Adds the share of a block's pixels that the first pass found. No colour is needed where it is 0
/// or 1 for all of them.
void add_unlit_share(const BlockResult& share, BlockResult& result);
[[nodiscard]] bool needs_unlit_colour(const FinishedTile& tile);
/// Adds the colour that the second pass found.
void add_unlit_colour(const BlockResult& colour, BlockResult& result);
/// Renders these passes, and adds both, to what `render_block` rendered. Nothing is added where the
/// block shows no unlit surface. Statistics stay those of the pass with light.
void add_unlit(const BlockJob& job, BlockResult& result);
/// Adds again what `add_unlit` found of a block, to better pixels of it: the colour of a pixel that
/// shows nothing else is the pixel's own.
void renew_unlit(std::vector<glm::vec4> unlit, BlockResult& result);
/// Fills in causes and rays that a method left out.
void fill_in(BlockResult& result);

/// `render_block` (renderer/render_block.h) by one of these methods.
[[nodiscard]] BlockResult render_block(const BlockJob& job,
                                       std::span<const MethodRow> methods = method_table());

/// The settings for a picture that is going to be shown by that curve: where the method judges what
/// shows it judges by the curve, and else the picture is the same by whichever it is shown. Studies
/// do not use it: their errors are those of radiance, clipped at white.
[[nodiscard]] RenderSettings judged_by(RenderSettings settings, ToneCurve curve);

/// The camera as the settings' method sees through it: its lens in focus, or a pinhole where the
/// method takes no lens.
[[nodiscard]] Camera viewed_camera(const RenderScene& scene, const Camera& camera,
                                   const RenderSettings& settings);

/// Side of the aligned blocks of pixels that are rendered as one piece of work.
[[nodiscard]] int block_side(const RenderSettings& settings);

/// The largest scene that beam tracing takes. Each block looks at every triangle, which is nearly
/// all its time: at this size some 0.6 ms a pixel, or ten minutes of one core for 1280x720.
inline constexpr std::size_t most_beam_triangles = 300'000;

/// Whether the method can render the scene, or why not: beam tracing refuses large ones.
[[nodiscard]] Result<void> check_method(const RenderScene& scene, const RenderSettings& settings);

}  // namespace asos
