#pragma once

#include "renderer/result.h"
#include "renderer/study/ladders.h"

#include <string>
#include <vector>

namespace asos {

/// A point of a plot. Both axes are logarithmic, so values that are not positive are left out.
struct PlotPoint {
  double seconds = 0.0;
  double value = 0.0;
  double least_seconds = 0.0;  ///< of its repetitions
  double most_seconds = 0.0;
  bool under_floor = false;  ///< below the noise floor: drawn differently
};

struct PlotCurve {
  std::string name;
  std::vector<PlotPoint> points;  ///< joined in their order
  bool strong = false;            ///< drawn with a wide line
};

/// Values of methods plotted against CPU time.
struct CurvePlot {
  std::string title;
  std::string value_title;
  std::vector<PlotCurve> curves;
  double floor = 0.0;  ///< a line across; 0: none
  double bias = 0.0;   ///< a second line across; 0: none
  std::string bias_title{};

  [[nodiscard]] bool empty() const;  ///< there is nothing to draw
  /// Adds a point to the curve of its step; those of ASOS are strong.
  void add(const LadderStep& step, const PlotPoint& point);
};

/// Checks that gnuplot is installed; the error says what to install.
[[nodiscard]] Result<void> check_gnuplot();

/// Draws the plot as path.svg and path.png, and keeps the gnuplot script with its data in the same
/// folder.
[[nodiscard]] Result<void> draw_plot(const CurvePlot& plot, const std::string& path);

}  // namespace asos
