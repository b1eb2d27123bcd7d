#pragma once

#include "renderer/study/analysis.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

/// A logarithmic axis over whole decades, and where on it a value is.
struct LogAxis {
  int first_decade = 0;  ///< it begins at 10^first_decade
  int decades = 1;       ///< at least 1

  /// 0 at its begin, 1 at its end; `value` is above 0.
  [[nodiscard]] double share(double value) const;
};
/// The axis over the decades that hold all of `values` above 0; the other values are left out.
[[nodiscard]] LogAxis axis_over(const std::vector<double>& values);

/// The contents of a plot of a study.
struct StudyPlot {
  struct Mark {
    double seconds = 0.0;
    double rmse = 0.0;
    bool under_floor = false;
  };
  struct Line {
    std::string curve;   ///< its name in the legend
    std::string method;  ///< its colour
    std::vector<Mark> marks;
  };
  std::vector<Line> lines;
  double floor = 0.0;  ///< 0: none known yet
  LogAxis seconds;
  LogAxis rmse;
};
/// The finished pictures of all settings, or the pictures of one setting per method while it
/// renders. Points without time or error are left out: a logarithm has no place for them.
enum class StudyCurves { finished, while_rendering };
[[nodiscard]] StudyPlot plot_of(const SceneStudy& study,
                                StudyCurves curves = StudyCurves::finished);

/// Draws into the current Dear ImGui window, over its width, with the legend below. `height_em`: of
/// the axes with their labels, in heights of text.
void draw_plot(const StudyPlot& plot, float height_em = 13.0f);

}  // namespace asos::ui
