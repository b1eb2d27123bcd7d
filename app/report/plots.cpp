#include "app/report/plots.h"

#include "app/report/gnuplot.h"
#include "app/report/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace asos {
namespace {

/// The plotted quantity of a point, and the axis's title.
struct Quantity {
  const char* ending;
  const char* title;
  double Measures::*value;
  bool has_floor;
};
constexpr std::array quantities{
    Quantity{"rmse", "RMSE, linear radiance clipped to 0..1", &Measures::rmse, true},
    Quantity{"perceptual", "Mean CIEDE2000 of the displayed picture", &Measures::perceptual, false},
};

constexpr const char* finished_note = "Bars reach from the quickest to the slowest repetition.";
constexpr const char* progress_title = "RMSE while rendering";
constexpr const char* progress_note =
    "A mark is the picture at that moment of one render, from the first whole picture to the "
    "finished one.";

PlotPoint plot_point(const StudyPoint& p, const Quantity& quantity) {
  const auto [lo, hi] = std::minmax_element(
      p.costs.begin(), p.costs.end(),
      [](const Cost& a, const Cost& b) { return a.cpu_seconds < b.cpu_seconds; });
  const bool ran = lo != p.costs.end();
  return {p.seconds(), p.measures.*quantity.value, ran ? lo->cpu_seconds : 0.0,
          ran ? hi->cpu_seconds : 0.0, p.under_floor};
}

CurvePlot plot_of(const SceneStudy& study, const Quantity& quantity) {
  CurvePlot plot{study.scene, quantity.title, {}, quantity.has_floor ? study.floor : 0.0};
  if (quantity.has_floor && study.bias) {
    plot.bias = study.bias->at_most;
    plot.bias_title = study.bias->levels_off ? "ASOS's own bias" : "ASOS's own bias, at most";
  }
  for (const StudyPoint& p : study.points) plot.add(p.rung, plot_point(p, quantity));
  return plot;
}

/// Explains the marks and names the renders that ended early.
std::string progress_note_of(const SceneStudy& study) {
  std::string note = progress_note;
  for (const RenderCurve& render : study.while_rendering)
    if (!render.finished)
      note += fmt::format(" {} {} ended early: it took too long.", render.method, render.setting);
  return note;
}

CurvePlot progress_plot_of(const SceneStudy& study) {
  CurvePlot plot{study.scene + ", while rendering", quantities.front().title, {}, study.floor};
  for (const RenderCurve& render : study.while_rendering) {
    const bool strong = render.method == "asos";
    PlotCurve& curve =
        plot.curves.emplace_back(PlotCurve{render.method + " " + render.setting, {}, strong});
    for (const CurvePoint& p : render.points)
      curve.points.push_back({p.seconds, p.error, p.seconds, p.seconds, p.error < study.floor});
  }
  return plot;
}

}  // namespace

Result<std::vector<Plot>> draw_plots(const SceneReport& scene, const std::string& folder,
                                     const std::string& name) {
  std::vector<Plot> plots;
  const auto draw = [&](const CurvePlot& plot, const char* ending, Plot drawn) -> Result<void> {
    if (plot.empty()) return {};
    drawn.path = figure_path(folder, name, ending);
    if (auto done = draw_plot(plot, drawn.path); !done) return done;
    plots.push_back(std::move(drawn));
    return {};
  };
  for (const Quantity& quantity : quantities)
    if (const auto drawn = draw(plot_of(scene.study, quantity), quantity.ending,
                                {quantity.title, finished_note, ""});
        !drawn)
      return tl::unexpected(drawn.error());
  if (const auto drawn = draw(progress_plot_of(scene.study), "progress",
                              {progress_title, progress_note_of(scene.study), ""});
      !drawn)
    return tl::unexpected(drawn.error());
  return plots;
}

}  // namespace asos
