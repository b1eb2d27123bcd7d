#include "renderer/comparison/method.h"
#include "ui/panels/panels.h"
#include "ui/panels/time_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asos::ui {

namespace {

constexpr std::array leaves{
    Controls::Option{"Exact area",
                     "Cells are cut along their edges and weighted by exact area. Straight edges "
                     "are exact at any MAX."},
    Controls::Option{"Point sample", "As published: one sample per cell."},
};

constexpr std::array rules{
    Controls::Option{"Total area < EPS",
                     "Stop when the area of all unresolved cells is below EPS."},
    Controls::Option{"Per object (published)",
                     "The published rule: stop when no object can change by more than EPS. Several "
                     "objects may add up to more."},
};

constexpr std::array detections{
    Controls::Option{"Pixel", "An edge counts where it crosses the pixel."},
    Controls::Option{
        "Cone",
        "As published: an edge counts where it crosses the cone around the pixel. Splits more."},
};

constexpr std::array texture_filters{
    Controls::Option{
        "Area",
        "Average textures and highlights over the area of a sample. Avoids moire and sparkle."},
    Controls::Option{"Point", "Look up textures and highlights at single points."},
};

// Adds a fraction to small values: 1/256 is one step of an 8-bit picture.
std::string eps_words(double eps) {
  if (eps <= 0.0) return "0: always to MAX";
  if (eps > 0.1) return fmt::format("{:.2f}", eps);
  return fmt::format("{:.4f}  =  1/{:.0f}", eps, 1.0 / eps);
}

std::string level_words(int max_level) {
  if (max_level == 0) return "0 (cut along edges only)";
  const int cells = 1 << max_level;
  return fmt::format("{} (up to {} x {})", max_level, cells, cells);
}

// Shows a dash if the estimate is for other settings or another view.
void forecast_row(Controls& controls, const Previewer& previewer, const SplitForecast& forecast) {
  const Forecast* told = forecast.of(previewer);
  const auto estimate = time_estimate(previewer, told);
  const auto share = shown_split_share(previewer, told);
  controls.row(
      "Estimate", told && estimate && share ? estimate_words(*share, *estimate) : std::string("-"),
      "Estimated share of split pixels and render time, from a few test blocks.", {true, 1});
}

// Pixels that a larger MAX would divide further. Unfinished pixels do not count.
void ended_by_max_row(Controls& controls, const CauseCounts& causes) {
  const double percent =
      100.0 * static_cast<double>(causes.ended_by_max) / static_cast<double>(causes.finished);
  controls.row("At MAX",
               causes.finished == 0 ? std::string("-") : fmt::format("{:.2g} % of pixels", percent),
               "Finished pixels with edges left at MAX: a larger MAX divides them further. The map "
               "Cause shows where.");
}

void splitting_sliders(Controls& controls, RenderSettings& settings, MaxTurn& turn) {
  const RenderSettings usual;
  controls.log_slider(
      "EPS",
      "Largest error allowed per pixel, 0 to 1. 1/256 is one 8-bit step. Larger is faster. "
      "Ctrl+click to type a value.",
      settings.asos.eps, {0.0, 1.0, usual.asos.eps}, eps_words);
  const std::string tooltip = turn.added_to(
      "Maximum splits per pixel, 0 to 8. Level n has cells of 1/2^n pixel, each with up to four "
      "samples. Smaller is faster and coarser. Ctrl+click to type a value.");
  controls.slider("MAX", tooltip.c_str(), settings.asos.max_level,
                  {0, max_level_limit, usual.asos.max_level}, level_words);
  explain_turned_max(controls, "MAX", turn);
}

// Controls for how cells are shaded and when splitting stops.
void splitting_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  if (settings.method == Method::asos) {
    controls.options("Cell shading", leaves, settings.asos.leaf, usual.asos.leaf);
    controls.options("Stop when", rules, settings.asos.rule, usual.asos.rule);
    controls.options("Edge test", detections, settings.asos.detect, usual.asos.detect);
    controls.checkbox(
        "Refine shading",
        "Also refine where shading varies within a pixel, such as highlights and curved surfaces.",
        settings.asos.refine_shading, usual.asos.refine_shading);
  }
  controls.checkbox(
      "Jitter unresolved cells",
      "Move samples of cells unresolved at MAX to random places. Noise replaces steps.",
      settings.asos.jitter, usual.asos.jitter);
}

// The methods round up to n x n samples, so the slider offers n.
void sample_controls(Controls& controls, RenderSettings& settings) {
  constexpr int max_side = 32;
  int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(settings.sampling.spp))));
  side = std::clamp(side, 1, max_side);
  const auto words = [](int n) { return fmt::format("{} x {} = {}", n, n, n * n); };
  if (controls.slider("Samples", "Samples per pixel: n x n.", side, {1, max_side, 4}, words)) {
    settings.sampling.spp = side * side;
  }
}

void seed_control(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.slider(
      "Seed", "Seed of the noise. Other seeds give other noise. Ctrl+click to type a value.",
      settings.seed, {0, 99, usual.seed}, [](int seed) { return fmt::format("{}", seed); });
}

// Controls of methods that sample each pixel until its error is small enough.
void adaptive_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.log_slider("EPS",
                      "Standard error at which a pixel gets no more samples, 0 to 1. Smaller has "
                      "less noise and is slower. Ctrl+click to type a value.",
                      settings.asos.eps, {0.0, 1.0, usual.asos.eps}, eps_words);
  controls.slider(
      "MAX", "Maximum samples per pixel: 4^(MAX+1), at least 16. Ctrl+click to type a value.",
      settings.asos.max_level, {0, max_level_limit, usual.asos.max_level}, [](int max) {
        return fmt::format("{} ({} to {} samples)", max, 16, std::max(16, 4 << (2 * max)));
      });
}

// Sobol takes any number of samples; the slider offers powers of two.
void sobol_controls(Controls& controls, RenderSettings& settings) {
  constexpr int most_doublings = 12;
  int doublings =
      static_cast<int>(std::lround(std::log2(static_cast<double>(settings.sampling.spp))));
  doublings = std::clamp(doublings, 0, most_doublings);
  if (controls.slider("Samples", "Samples per pixel, a power of two.", doublings,
                      {0, most_doublings, 4}, [](int n) { return fmt::format("{}", 1 << n); })) {
    settings.sampling.spp = 1 << doublings;
  }
}

// A width in pixels. Rounds to 0.01 pixel, so that the saved value equals the typed one.
void width_control(Controls& controls, const char* name, const char* tooltip, double& width,
                   const Controls::Range<double>& range) {
  if (controls.slider(name, tooltip, width, range,
                      [](float w) { return fmt::format("{:.2f} px", w); }))
    width = std::round(100.0 * width) / 100.0;
}

void texture_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.options("Texture filter", texture_filters, settings.texture.filter,
                   usual.texture.filter);
  if (!in_object_space(settings.method)) return;
  // Area averages need no TR above 1; a larger one still takes effect.
  if (settings.texture.filter == TextureFilter::footprint && settings.texture.resolution == 1)
    return;
  controls.slider("TR",
                  "TR x TR texture samples per pixel without edges, 1 to 8 (CGF'98 section 3.2). "
                  "Only needed with point filtering.",
                  settings.texture.resolution,
                  {1, TextureSettings::max_resolution, usual.texture.resolution},
                  [](int n) { return n == 1 ? std::string("1") : fmt::format("{0} x {0}", n); });
}

}  // namespace

std::vector<Method> methods_for(const RenderSettings& settings, const RenderScene* scene) {
  std::vector<Method> offered;
  for (const MethodRow& row : method_table()) {
    RenderSettings asked = settings;
    asked.method = row.value;
    if (scene ? !check_method(*scene, asked) : row.limited()) continue;
    offered.push_back(row.value);
  }
  return offered;
}

void method_list(Controls& controls, const char* name, RenderSettings& settings,
                 const RenderScene* scene) {
  const std::vector<Method> offered = methods_for(settings, scene);
  std::vector<Controls::Option> options;
  for (const Method method : offered)
    options.push_back({row_of(method).title, row_of(method).about});
  const auto at = std::find(offered.begin(), offered.end(), settings.method);
  auto chosen = static_cast<int>(at - offered.begin());
  if (controls.described_list(name, options, chosen))
    settings.method = offered[static_cast<std::size_t>(chosen)];
}

void explain_turned_max(Controls& controls, const char* slider, MaxTurn& turn) {
  const bool active = ImGui::IsItemActive();
  if (active && !turn.words.empty()) controls.tell(slider, turn.words.c_str());
  turn.turned |= active || controls.told().name == slider;
}

void antialiasing_panel(Controls& controls, Previewer& previewer, const SplitForecast& forecast,
                        const BarParts& bar, const CauseCounts& causes, MaxTurn& turn) {
  RenderSettings& settings = previewer.edits().settings();
  const RenderScene* scene = previewer.scene().get();
  if (!controls.section("Antialiasing")) return;
  if (!bar.method || controls.searches()) method_list(controls, "Method", settings, scene);
  const bool splits = in_object_space(settings.method);
  const bool by_eps = row_of(settings.method).samples_by_eps;
  const bool sliders = !bar.splitting || controls.searches();
  if (splits && sliders) splitting_sliders(controls, settings, turn);
  if (by_eps && sliders) adaptive_controls(controls, settings);
  if (splits) {
    forecast_row(controls, previewer, forecast);
    ended_by_max_row(controls, causes);
  }
  if (settings.method == Method::uniform || settings.method == Method::stochastic)
    sample_controls(controls, settings);
  if (settings.method == Method::sobol) sobol_controls(controls, settings);
  if (settings.method == Method::sobol || by_eps) seed_control(controls, settings);
  if (scene && !scene->world().lines_and_points.empty())
    width_control(
        controls, "Lines",
        "Width of lines and points, 0 to 16 pixels. 0 hides them. Ctrl+click to type a value.",
        settings.line_width, {0.0, RenderSettings::max_line_width, RenderSettings{}.line_width});
}

void advanced_panel(Controls& controls, Previewer& previewer) {
  RenderSettings& settings = previewer.edits().settings();
  const RenderScene* scene = previewer.scene().get();
  const RenderSettings usual;
  if (!controls.section("Advanced (papers)", false)) return;
  if (in_object_space(settings.method)) splitting_controls(controls, settings);
  if (row_of(settings.method).takes_filter_width)
    width_control(controls, "Pixel filter",
                  "Width of the box filter, 1 to 4 pixels. Above 1: softer, less flicker. "
                  "Ctrl+click to type a value.",
                  settings.filter_width,
                  {1.0, RenderSettings::max_filter_width, usual.filter_width});
  shadow_rules(controls, settings, scene);
  // Without a scene, show only the controls that every scene has.
  if (scene && scene->render_features.mirrors) curved_mirror_controls(controls, settings);
  if (scene && scene->render_features.textures) texture_controls(controls, settings);
  if (!scene || !scene->render_features.culling) return;
  controls.checkbox("Back-face culling", "Hide the backs of single-sided materials, as glTF asks.",
                    settings.cull, usual.cull);
}

}  // namespace asos::ui
