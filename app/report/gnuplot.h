#pragma once

#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// A point of a plot. Values that are not above 0 are left out, for both axes are logarithmic.
struct PlotPoint {
  double seconds = 0.0;
  double value = 0.0;
  double least_seconds = 0.0;  ///< of its repetitions
  double most_seconds = 0.0;
  bool under_floor = false;  ///< hardly known: drawn apart
};

struct PlotCurve {
  std::string name;
  std::vector<PlotPoint> points;  ///< joined in their order
  bool strong = false;            ///< drawn with a wide line
};

/// Values of methods over processor seconds.
struct CurvePlot {
  std::string title;
  std::string value_title;
  std::vector<PlotCurve> curves;
  double floor = 0.0;  ///< a line across; 0: none
  double bias = 0.0;   ///< the same
  std::string bias_title{};

  [[nodiscard]] bool empty() const;  ///< there is nothing to draw
};

/// Whether gnuplot is there, or what to install.
[[nodiscard]] Result<void> check_gnuplot();

/// Draws it as path.svg and path.png; the gnuplot script, data and all, is left beside them.
[[nodiscard]] Result<void> draw_plot(const CurvePlot& plot, const std::string& path);

}  // namespace asos
