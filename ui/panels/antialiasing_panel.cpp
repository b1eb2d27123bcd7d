#include "renderer/comparison/method.h"
#include "ui/panels/panels.h"
#include "ui/panels/time_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asos {

namespace {

constexpr std::array leaves{
    Controls::Option{"Exact",
                     "A cell that a single boundary crosses is cut along it; both parts count by "
                     "their exact area. Straight edges come out exact at any level."},
    Controls::Option{"Point", "As published: one sample for every cell that is not split."},
};

constexpr std::array rules{
    Controls::Option{"Unresolved area",
                     "Stop when the area of all cells that are still undecided is EPS at most."},
    Controls::Option{"Published",
                     "Stop when no object's share can change by more than EPS: L / 2^2K. With "
                     "several objects in a pixel their changes may add up to more."},
};

constexpr std::array detections{
    Controls::Option{"Square", "A boundary counts where it crosses the pyray itself."},
    Controls::Option{"Cone",
                     "As published: a boundary counts where it crosses the cone around the pyray, "
                     "which splits more."},
};

constexpr std::array texture_filters{
    Controls::Option{"Footprint",
                     "Textures, and highlights where a surface turns, are averaged over the patch "
                     "that a sample stands for: no moire, no sparkle."},
    Controls::Option{"Points",
                     "Textures and highlights are looked up just where a sample's ray hits."},
};

// As a fraction where that says more: 1/256 is one step of an 8-bit picture.
std::string eps_words(double eps) {
  if (eps <= 0.0) return "0: always to MAX";
  if (eps > 0.1) return fmt::format("{:.2f}", eps);
  return fmt::format("{:.4f}  =  1/{:.0f}", eps, 1.0 / eps);
}

std::string level_words(int max_level) {
  if (max_level == 0) return "0: whole pixels";
  const int cells = 1 << max_level;
  return fmt::format("{}: up to {} x {} cells", max_level, cells, cells);
}

// Options in the order of the values of an enumeration.
template <typename T>
void choose(Controls& controls, const char* label, std::span<const Controls::Option> options,
            T& value, T reset) {
  int index = static_cast<int>(value);
  if (controls.options(label, options, index, {true, static_cast<int>(reset)}))
    value = static_cast<T>(index);
}

// Whether the control just drawn is being dragged.
bool is_held() {
  return ImGui::IsItemActive() && !ImGui::GetIO().WantTextInput;
}

void forecast_row(Controls& controls, const Previewer& previewer, SplitForecast& forecast) {
  std::string words = "comes while EPS or MAX is dragged";
  if (const Forecast* told = forecast.of(previewer)) words = forecast_words(*told);
  controls.row(
      "Forecast", words,
      "The share of pixels that would be split, and how many seconds of the clock the render would "
      "take on all its threads; told by blocks all over the picture, before it is rendered.",
      {true, 2});
}

void asos_controls(Controls& controls, Previewer& previewer, SplitForecast& forecast) {
  RenderSettings& settings = previewer.edits().settings();
  const RenderSettings usual;
  controls.log_slider(
      "EPS",
      "The error that you accept in a pixel's display intensity, 0 to 1. Smaller is "
      "finer and slower. 1/256 is one step of an 8-bit picture. Ctrl+click to type "
      "a value.",
      settings.asos.eps, {0.0, 1.0, usual.asos.eps}, eps_words);
  bool held = is_held();
  controls.slider("MAX",
                  "Maximum splits of a pixel, 0 to 8. Level n has cells of 1/2^n pixel, with at "
                  "most four samples each. Smaller is faster and coarser. Ctrl+click to type a "
                  "value.",
                  settings.asos.max_level, {0, max_level_limit, usual.asos.max_level}, level_words);
  held |= is_held();
  if (held) forecast.ask(previewer);
  forecast_row(controls, previewer, forecast);
  if (settings.method == Method::asos) {
    choose(controls, "Leaf", leaves, settings.asos.leaf, usual.asos.leaf);
    choose(controls, "Rule", rules, settings.asos.rule, usual.asos.rule);
    choose(controls, "Detection", detections, settings.asos.detect, usual.asos.detect);
    controls.checkbox("Shading",
                      "Split what is shaded unevenly, too: strongly bent surfaces, and what lies "
                      "close to a light.",
                      settings.asos.refine_shading, usual.asos.refine_shading);
  }
  controls.checkbox("Jitter",
                    "Move the samples of cells that are still undecided at level MAX to random "
                    "places: noise instead of steps.",
                    settings.asos.jitter, usual.asos.jitter);
}

// The methods round up to n x n samples, so n is what the slider offers.
void sample_controls(Controls& controls, RenderSettings& settings) {
  constexpr int max_side = 32;
  int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(settings.sampling.spp))));
  side = std::clamp(side, 1, max_side);
  const auto words = [](int n) { return fmt::format("{} x {} = {}", n, n, n * n); };
  if (controls.slider("Samples", "Samples in each pixel: n x n.", side, {1, max_side, 4}, words)) {
    settings.sampling.spp = side * side;
  }
}

void seed_control(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.slider("Seed",
                  "Number of the scrambling: another seed gives another picture of the same noise. "
                  "Ctrl+click to type a value.",
                  settings.seed, {0, 99, usual.seed},
                  [](int seed) { return fmt::format("{}", seed); });
}

// For methods that sample each pixel on until it is good enough.
void adaptive_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.log_slider("EPS",
                      "The standard error, of display intensity (0 to 1), at which a pixel takes "
                      "no more samples. Smaller: less noise, slower. Ctrl+click to type a value.",
                      settings.asos.eps, {0.0, 1.0, usual.asos.eps}, eps_words);
  controls.slider("MAX",
                  "A pixel takes 4^MAX times 4 samples at most, and never fewer than 16. "
                  "Ctrl+click to type a value.",
                  settings.asos.max_level, {0, max_level_limit, usual.asos.max_level}, [](int max) {
                    return fmt::format("{}: {} to {} samples", max, 16,
                                       std::max(16, 4 << (2 * max)));
                  });
  seed_control(controls, settings);
}

// Sobol takes any number of samples; twice as many a step of the slider.
void sobol_controls(Controls& controls, RenderSettings& settings) {
  constexpr int most_doublings = 12;
  int doublings =
      static_cast<int>(std::lround(std::log2(static_cast<double>(settings.sampling.spp))));
  doublings = std::clamp(doublings, 0, most_doublings);
  if (controls.slider("Samples", "Samples in each pixel, a power of two.", doublings,
                      {0, most_doublings, 4}, [](int n) { return fmt::format("{}", 1 << n); })) {
    settings.sampling.spp = 1 << doublings;
  }
  seed_control(controls, settings);
}

// In hundredths of a pixel, so that what is typed is what is saved.
void filter_control(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  auto width = static_cast<float>(settings.filter_width);
  if (controls.slider("Filter",
                      "Side of the square around its middle that a pixel is the mean of, 1 to 4 "
                      "pixels. Wider than 1, pixels overlap: softer, and calmer where it moves. "
                      "Ctrl+click to type a value.",
                      width,
                      {1.0f, static_cast<float>(RenderSettings::max_filter_width),
                       static_cast<float>(usual.filter_width)},
                      [](float w) { return fmt::format("{:.2f} pixels", w); }))
    settings.filter_width = std::round(100.0 * static_cast<double>(width)) / 100.0;
}

void line_control(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  auto width = static_cast<float>(settings.line_width);
  if (controls.slider("Lines",
                      "Width of the scene's lines, and the diameter of its points, 0 to 16 pixels; "
                      "0 leaves them out. Ctrl+click to type a value.",
                      width,
                      {0.0f, static_cast<float>(RenderSettings::max_line_width),
                       static_cast<float>(usual.line_width)},
                      [](float w) { return fmt::format("{:.2f} pixels", w); }))
    settings.line_width = std::round(100.0 * static_cast<double>(width)) / 100.0;
}

void texture_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  choose(controls, "Textures", texture_filters, settings.texture.filter, usual.texture.filter);
  if (!in_object_space(settings.method)) return;
  controls.slider("TR",
                  "Texture resolution: TR x TR jittered samples of each pixel of textured surface "
                  "that nothing bounds, 1 to 8 (CGF'98 section 3.2). Needed where textures are "
                  "looked up at points.",
                  settings.texture.resolution,
                  {1, TextureSettings::max_resolution, usual.texture.resolution},
                  [](int n) { return n == 1 ? std::string("1") : fmt::format("{0} x {0}", n); });
}

// Offers the methods that can render the scene; without a scene, those that can render any.
void method_choice(Controls& controls, RenderSettings& settings, const RenderScene* scene) {
  std::vector<Method> offered;
  std::vector<Controls::Option> options;
  for (const MethodRow& row : method_table()) {
    RenderSettings asked = settings;
    asked.method = row.value;
    if (scene ? !check_method(*scene, asked) : row.limited()) continue;
    offered.push_back(row.value);
    options.push_back({row.title, row.about});
  }
  const auto at = std::find(offered.begin(), offered.end(), settings.method);
  auto chosen = static_cast<int>(at - offered.begin());
  if (controls.options("Method", options, chosen, {false, std::nullopt}))
    settings.method = offered[static_cast<std::size_t>(chosen)];
}

}  // namespace

void antialiasing_panel(Controls& controls, Previewer& previewer, SplitForecast& forecast) {
  RenderSettings& settings = previewer.edits().settings();
  const RenderScene* scene = previewer.scene().get();
  const RenderSettings usual;
  if (!controls.section("Antialiasing")) return;
  method_choice(controls, settings, scene);
  if (in_object_space(settings.method)) asos_controls(controls, previewer, forecast);
  if (settings.method == Method::uniform || settings.method == Method::stochastic) {
    sample_controls(controls, settings);
  }
  if (settings.method == Method::sobol) sobol_controls(controls, settings);
  if (row_of(settings.method).samples_by_eps) adaptive_controls(controls, settings);
  if (row_of(settings.method).takes_filter_width) filter_control(controls, settings);
  if (scene && !scene->world().strokes.empty()) line_control(controls, settings);
  if (!scene || scene->needs.textures) texture_controls(controls, settings);
  if (scene && !scene->needs.culling) return;
  controls.checkbox("Culling",
                    "Leave out the backs of surfaces whose material is not double-sided, as glTF "
                    "says. Without it they are seen from both sides.",
                    settings.cull, usual.cull);
}

}  // namespace asos
