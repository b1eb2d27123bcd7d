#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {

namespace {

constexpr std::array methods{
    Controls::Option{"ASOS",
                     "Adaptive supersampling in object space: a pixel is split only where the "
                     "boundary of an object passes through it."},
    Controls::Option{"Uniform", "A regular grid of n x n samples in every pixel."},
    Controls::Option{"Stochastic", "n x n jittered samples in every pixel."},
};

constexpr std::array leaves{
    Controls::Option{"Exact",
                     "A cell that a single boundary crosses is cut along it; both parts count by "
                     "their exact area. Straight edges come out exact at any level."},
    Controls::Option{"Point", "As published: one sample for every cell that is not split."},
};

void asos_controls(Controls& controls, RenderSettings& settings) {
  const std::string format = settings.eps > 0.0
                                 ? fmt::format("%.4f  (1/{:.0f})", 1.0 / settings.eps)
                                 : std::string("%.4f");
  controls.log_slider("EPS",
                      "How much a pixel's display intensity (0 to 1) may still change when its "
                      "splitting stops. Smaller: finer, slower. 1/256 is one step of an 8-bit "
                      "picture. Ctrl+click to type a value.",
                      settings.eps, 0.0, 1.0, format.c_str());
  controls.slider("MAX",
                  "The deepest level to which a pixel is split: up to 4^MAX cells. 0: one sample a "
                  "pixel.",
                  settings.max_level, 0, RenderSettings::max_level_limit);
  int leaf = settings.leaf == Leaf::exact ? 0 : 1;
  if (controls.options("Leaf", leaves, leaf)) {
    settings.leaf = leaf == 0 ? Leaf::exact : Leaf::point;
  }
  controls.checkbox("Jitter",
                    "Move the samples of cells that are still undecided at level MAX to random "
                    "places: noise instead of steps.",
                    settings.jitter);
}

// The methods round up to n x n samples, so n is what the slider offers.
void sample_controls(Controls& controls, RenderSettings& settings) {
  constexpr int max_side = 32;
  int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(settings.spp))));
  side = std::clamp(side, 1, max_side);
  const std::string format = fmt::format("%d x {} = {}", side, side * side);
  if (controls.slider("Samples", "Samples a pixel: n x n.", side, 1, max_side, format.c_str())) {
    settings.spp = side * side;
  }
}

}  // namespace

void antialiasing_panel(Controls& controls, RenderSettings& settings) {
  if (!controls.section("Antialiasing")) return;
  int method = static_cast<int>(settings.method);
  if (controls.options("Method", methods, method)) settings.method = static_cast<Method>(method);
  if (settings.method == Method::asos) {
    asos_controls(controls, settings);
  } else {
    sample_controls(controls, settings);
  }
}

}  // namespace asos
