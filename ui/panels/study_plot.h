#pragma once

#include "renderer/study/analysis.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

/// A logarithmic axis over whole decades.
struct LogAxis {
  int first_decade = 0;  ///< the axis begins at 10^first_decade
  int decades = 1;       ///< at least 1

  /// Position of `value`, which is positive: 0 at the axis's begin, 1 at its end.
  [[nodiscard]] double share(double value) const;
};
/// The axis over the decades of all positive `values`.
[[nodiscard]] LogAxis axis_over(const std::vector<double>& values);

/// A log-log plot of RMSE over CPU seconds, with one line per curve of a method.
struct StudyPlot {
  struct Mark {
    double seconds = 0.0;
    double rmse = 0.0;
    bool under_floor = false;
  };
  struct Line {
    std::string curve;    ///< its name in the legend
    std::string method;   ///< its colour
    bool dashed = false;  ///< an earlier line has the same colour
    std::vector<Mark> marks;
  };
  std::vector<Line> lines;
  double floor = 0.0;  ///< 0: none known yet
  LogAxis seconds;
  LogAxis rmse;
};
/// The finished pictures of all settings, or for each method the pictures of one setting during its
/// render. Points without time or error are left out, because their logarithm is undefined.
enum class StudyCurves { finished, while_rendering };
[[nodiscard]] StudyPlot plot_of(const SceneStudy& study,
                                StudyCurves curves = StudyCurves::finished);

/// Draws the plot over the width of the current Dear ImGui window, with the legend below.
/// `height_em`: height of the axes with their labels, in heights of text.
void draw_plot(const StudyPlot& plot, float height_em = 13.0f);
/// Returns the number of rows of the legend in the current Dear ImGui window.
[[nodiscard]] int legend_rows(const StudyPlot& plot);
/// Returns the words of a line in a legend.
[[nodiscard]] std::string legend_words(const StudyPlot::Line& line);

}  // namespace asos::ui
