#include "renderer/comparison/method.h"

#include "renderer/asos/asos.h"
#include "renderer/comparison/over_time.h"
#include "renderer/comparison/published_motion.h"
#include "renderer/prepared/focus.h"
#include "renderer/samples/sobol_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace asos {

// One function per method, each in the file of its name.
BlockResult render_block_sobol_adaptive(const BlockJob& job);
BlockResult render_block_whitted(const BlockJob& job);
BlockResult render_block_mitchell(const BlockJob& job);
BlockResult render_block_ray_bound(const BlockJob& job);
BlockResult render_block_average(const BlockJob& job);
BlockResult render_block_beam(const BlockJob& job);
BlockResult render_block_cone(const BlockJob& job);
BlockResult render_block_covers(const BlockJob& job);
BlockResult render_block_mask(const BlockJob& job);

namespace {

BlockResult render_block_as_published(const BlockJob& job) {
  const RenderSettings published = as_published(job.settings);
  return job.motion ? render_published_motion(job.with(published))
                    : render_block_asos(job.with(published));
}

/// Renders the same number of samples in every pixel, placed as the method's row says.
BlockResult render_block_sampled(const BlockJob& job) {
  const std::unique_ptr<PixelSampler> places = row_of(job.settings.method).places(job.settings);
  return sample_block(job, *places, samples_a_pixel(job.settings));
}

std::unique_ptr<PixelSampler> uniform_places(const RenderSettings& settings) {
  return std::make_unique<GridSampler>(grid_side(settings.sampling.spp), false);
}
std::unique_ptr<PixelSampler> stochastic_places(const RenderSettings& settings) {
  return std::make_unique<GridSampler>(grid_side(settings.sampling.spp), true);
}
std::unique_ptr<PixelSampler> sobol_sampler(const RenderSettings& settings) {
  return std::make_unique<SobolSampler>(settings.seed);
}

int usual_side(const RenderSettings& /*settings*/) {
  return block_size;
}

// The block consists of whole fat pyrays.
int fat_side(const RenderSettings& settings) {
  return std::max(block_size, settings.asos.fat);
}

// Larger blocks, for three kinds of methods:
// - pixels share samples with their neighbours: each block takes those along its border again.
// - pixels are continued if a neighbour is: pixels along the border lack some neighbours.
// - all pixels are sampled in rounds: one sample per pixel has to fill packets of rays.
int large_side(const RenderSettings& /*settings*/) {
  return 32;
}

constexpr std::array<MethodRow, static_cast<std::size_t>(last_method) + 1> rows{{
    {.value = Method::asos,
     .name = "asos",
     .title = "ASOS",
     .about = "Adaptive supersampling in object space: pixels are split only where object edges "
              "cross them.",
     .render = render_block_asos,
     .start = start_block_asos,
     .block_side = fat_side,
     .in_object_space = true,
     .needs_boundaries = true,
     .judges_display = true,
     .takes_filter_width = true},
    {.value = Method::asos_published,
     .name = "asos-published",
     .hint = "cone, point leaves, published rule",
     .title = "As published",
     .about = "The original algorithm: cone test, point samples, published stop rule.",
     .render = render_block_as_published,
     .block_side = fat_side,
     .in_object_space = true,
     .needs_boundaries = true,
     .takes_filter_width = true,
     .samples_time = true},
    {.value = Method::uniform,
     .name = "uniform",
     .hint = "n x n grid",
     .title = "Uniform",
     .about = "A regular grid of n x n samples in every pixel.",
     .render = render_block_sampled,
     .block_side = large_side,
     .takes_filter_width = true,
     .samples_time = true,
     .samples = SampleCount::squares,
     .places = uniform_places},
    {.value = Method::stochastic,
     .name = "stochastic",
     .hint = "jittered",
     .title = "Stochastic",
     .about = "n x n jittered samples in every pixel.",
     .render = render_block_sampled,
     .block_side = large_side,
     .takes_filter_width = true,
     .samples_time = true,
     .samples = SampleCount::squares,
     .places = stochastic_places},
    {.value = Method::sobol,
     .name = "sobol",
     .hint = "Owen-scrambled",
     .title = "Sobol",
     .about = "Fixed number of Owen-scrambled Sobol samples per pixel. The reference method.",
     .render = render_block_sampled,
     .block_side = large_side,
     .takes_filter_width = true,
     .samples_time = true,
     .samples = SampleCount::any,
     .places = sobol_sampler},
    {.value = Method::sobol_adaptive,
     .name = "sobol-adaptive",
     .hint = "until the standard error is below EPS",
     .title = "Adaptive Sobol",
     .about = "Sobol sampling until the standard error is below EPS (16 to 4^(MAX+1) samples).",
     .render = render_block_sobol_adaptive,
     .block_side = large_side,
     .judges_display = true,
     .samples_by_eps = true,
     .takes_filter_width = true,
     .samples_time = true},
    {.value = Method::whitted,
     .name = "whitted",
     .hint = "adaptive between pixel corners",
     .title = "Whitted",
     .about = "Image-space supersampling: samples at pixel corners, split where corners differ.",
     .render = render_block_whitted,
     .block_side = large_side,
     .judges_display = true,
     .samples_time = true},
    {.value = Method::mitchell,
     .name = "mitchell",
     .hint = "two densities, by contrast",
     .title = "Mitchell",
     .about = "Four samples per pixel, more where their contrast is high.",
     .render = render_block_mitchell,
     .block_side = usual_side,
     .judges_display = true,
     .samples_time = true,
     .samples = SampleCount::any},
    {.value = Method::ray_bound,
     .name = "ray-bound",
     .hint = "all samples at edges, else one",
     .title = "Edges only",
     .about = "n x n jittered samples in pixels with edges, one elsewhere.",
     .render = render_block_ray_bound,
     .block_side = usual_side,
     .needs_boundaries = true,
     .samples_time = true,
     .samples = SampleCount::squares},
    {.value = Method::average,
     .name = "average",
     .hint = "mean of 3 x 3 pixel centres",
     .title = "3 x 3 blur",
     .about = "One sample per pixel, averaged over 3 x 3 pixels.",
     .render = render_block_average,
     .block_side = large_side,
     .samples_time = true},
    {.value = Method::beam,
     .name = "beam",
     .hint = "exact, for small scenes",
     .title = "Beam",
     .about = "Exact area of every visible polygon. For small scenes only.",
     .render = render_block_beam,
     .block_side = usual_side,
     .takes_lens = false,
     .takes_motion = false,
     .renders_layers = false,
     .takes_shapes = false,
     .most_triangles = most_beam_triangles},
    {.value = Method::cone,
     .name = "cone",
     .hint = "fractions of a cone, for small scenes",
     .title = "Cone",
     .about = "Each object hides a fraction of the pixel's cone, wherever it lies in it.",
     .render = render_block_cone,
     .block_side = usual_side,
     .takes_lens = false,
     .takes_motion = false,
     .renders_layers = false,
     .takes_shapes = false,
     .most_triangles = most_beam_triangles},
    {.value = Method::covers,
     .name = "covers",
     .hint = "by distance to the edge, for small scenes",
     .title = "Covers",
     .about = "Objects are weighted by the distance of their nearest edge from the pixel's centre.",
     .render = render_block_covers,
     .block_side = usual_side,
     .takes_lens = false,
     .takes_motion = false,
     .renders_layers = false,
     .takes_shapes = false,
     .most_triangles = most_beam_triangles},
    {.value = Method::mask,
     .name = "mask",
     .hint = "8 x 8 coverage masks, for small scenes",
     .title = "Coverage mask",
     .about = "Triangles cover some of 8 x 8 points of a pixel; each is shaded once (A-buffer).",
     .render = render_block_mask,
     .block_side = usual_side,
     .takes_lens = false,
     .takes_motion = false,
     .renders_layers = false,
     .takes_shapes = false,
     .most_triangles = most_beam_triangles},
}};

static_assert([] {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].value != static_cast<Method>(i)) return false;
  return true;
}());

}  // namespace

std::span<const MethodRow> method_table() {
  return rows;
}

const MethodRow& row_of(Method method) {
  assert(method >= Method::asos && method <= last_method);
  return rows[static_cast<std::size_t>(method)];
}

bool shows_coverage(const RenderSettings& settings) {
  return settings.background.kind == BackgroundKind::transparent &&
         settings.background.content == PixelContent::light;
}

RenderSettings coverage_of(RenderSettings settings) {
  settings.background.content = PixelContent::coverage;
  settings.layers = {};
  settings.sky = nullptr;
  settings.shadow = {};
  settings.shadow.cast = false;
  return settings;
}

RenderSettings with_coverage(RenderSettings settings) {
  settings.layers.insert(Layer::alpha);
  return settings;
}

void take_coverage(LayerSet asked, BlockResult& result) {
  std::vector<LayerPlane>& layers = result.tile.layers;
  const auto alpha = std::find_if(layers.begin(), layers.end(), [](const LayerPlane& plane) {
    return plane.layer == Layer::alpha;
  });
  if (alpha == layers.end()) return;
  if (asked.has(Layer::alpha)) {
    result.tile.coverage = alpha->values;
  } else {
    result.tile.coverage = std::move(alpha->values);
    layers.erase(alpha);
  }
}

void set_coverage(const BlockResult& covered, BlockResult& result) {
  result.tile.coverage.clear();
  result.tile.coverage.reserve(covered.tile.radiance.size());
  for (const glm::vec3& share : covered.tile.radiance)
    result.tile.coverage.push_back((share.x + share.y + share.z) / 3.0f);
  result.statistics.eye_rays += covered.statistics.eye_rays;
}

void fill_in(BlockResult& result) {
  // Methods that do not split pixels have no causes.
  const std::size_t pixels = result.tile.split_level.size();
  result.tile.cause.resize(pixels, SplitCause::none);
  // Methods that do not count rays by pixel get the mean for each.
  if (result.tile.rays.size() != pixels && pixels > 0) {
    const auto mean = static_cast<double>(result.statistics.rays()) / static_cast<double>(pixels);
    result.tile.rays.assign(pixels, static_cast<float>(mean));
  }
}

BlockResult render_pixels(const BlockJob& job, std::span<const MethodRow> methods) {
  const auto row = std::find_if(methods.begin(), methods.end(), [&](const MethodRow& method) {
    return method.value == job.settings.method;
  });
  assert(row != methods.end());
  return job.motion && !row->samples_time ? render_over_time(job, *row) : row->render(job);
}

BlockResult render_block(const BlockJob& job, std::span<const MethodRow> methods) {
  const bool covers = shows_coverage(job.settings);
  if (covers && covers_by_layer(job.settings.method)) {
    const RenderSettings covered = with_coverage(job.settings);
    BlockResult result = render_pixels(job.with(covered), methods);
    fill_in(result);
    take_coverage(job.settings.layers, result);
    return result;
  }
  BlockResult result = render_pixels(job, methods);
  fill_in(result);
  if (covers) {
    const RenderSettings covered = coverage_of(job.settings);
    set_coverage(render_pixels(job.with(covered), methods), result);
  }
  return result;
}

BlockResult render_block(const RenderScene& scene, const View& view, const RenderSettings& settings,
                         PixelRect block, const std::stop_token& stop) {
  return render_block({scene, view, settings, block, stop});
}

RenderSettings judged_by(RenderSettings settings, ToneCurve curve) {
  settings.judged_tone = row_of(settings.method).judges_display ? curve : ToneCurve::none;
  return settings;
}

Camera viewed_camera(const RenderScene& scene, const Camera& camera,
                     const RenderSettings& settings) {
  if (row_of(settings.method).takes_lens) return focused(scene, camera, settings);
  Camera pinhole = camera;
  pinhole.lens = {};
  return pinhole;
}

std::optional<MovingPicture> moving_picture(const RenderScene& scene, const Camera& camera,
                                            const RenderSettings& settings) {
  const bool moves = settings.shutter.blurs() && scene.exposure && scene.exposure->moves();
  if (!moves || !row_of(settings.method).takes_motion) return std::nullopt;
  return std::make_optional<MovingPicture>(scene, camera, settings);
}

RenderFeatures needs_of_picture(const RenderScene& scene, const RenderSettings& settings) {
  RenderFeatures needs = needs_of(scene, settings);
  needs.boundaries = scene.forced.boundaries || needs_boundaries(settings.method);
  return needs;
}

int samples_a_pixel(const RenderSettings& settings) {
  const int spp = settings.sampling.spp;
  if (row_of(settings.method).samples != SampleCount::squares) return spp;
  const int side = grid_side(spp);
  return side * side;
}

int block_side(const RenderSettings& settings) {
  return row_of(settings.method).block_side(settings);
}

Result<void> check_method(const RenderScene& scene, const RenderSettings& settings) {
  const MethodRow& method = row_of(settings.method);
  if (!method.takes_shapes && !scene.world().faces.empty()) {
    return unexpected(
        Error{"method",
              fmt::format("{} is for triangles, and this scene has analytic shapes", method.name)});
  }
  if (settings.layers.of_surfaces() && !renders_layers(settings.method)) {
    std::string able;
    for (const MethodRow& row : rows)
      if (renders_layers(row.value))
        able += fmt::format("{}{}", able.empty() ? "" : ", ", row.name);
    return unexpected(
        Error{"layers", fmt::format("{} renders none; these do: {}", method.name, able)});
  }
  const std::size_t triangles = scene.world().triangles.size();
  if (triangles <= method.most_triangles) return {};
  return unexpected(
      Error{"method", fmt::format("{} is for scenes of up to {} triangles, and this one has {}",
                                  method.name, method.most_triangles, triangles)});
}

}  // namespace asos
