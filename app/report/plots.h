#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// A plot of a scene: the path without extension, for .svg and .png.
struct Plot {
  std::string title;
  std::string note;  ///< one sentence about the marks
  std::string path;
};

/// Plots the errors of a scene's points against their times with logarithmic axes: the RMSE, the
/// perceptual error, and the RMSE during renders. Keeps the gnuplot scripts with their data in the
/// same folder.
[[nodiscard]] Result<std::vector<Plot>> draw_plots(const SceneReport& scene,
                                                   const std::string& folder,
                                                   const std::string& name);

}  // namespace asos
