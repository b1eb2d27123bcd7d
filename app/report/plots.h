#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// A plot of a scene: the file without its ending; .svg and .png are both there.
struct Plot {
  std::string title;
  std::string note;  ///< a sentence on what the marks are
  std::string path;
};

/// Draws the errors of a scene's points over their times, both axes logarithmic: the root mean
/// square and the perceptual one; and the root mean square of the pictures while they render. The
/// gnuplot scripts, data and all, are left beside the plots.
[[nodiscard]] Result<std::vector<Plot>> draw_plots(const SceneReport& scene,
                                                   const std::string& folder,
                                                   const std::string& name);

}  // namespace asos
