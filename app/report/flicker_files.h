#pragma once

#include "app/report/flicker_study.h"
#include "app/report/gnuplot.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// A method's film strip: PNG files with the frames side by side.
struct ShownStrip {
  std::string label;
  std::string frames;
  std::string errors;   ///< RMSE of each frame; empty for the reference
  std::string flicker;  ///< flicker of the whole picture; empty for the reference
  const FlickerPoint* point = nullptr;
};

/// Files of a study's figures.
struct FlickerFigures {
  std::vector<std::string> plots;  ///< paths without extensions; may be empty
  std::vector<ShownStrip> strips;  ///< the reference first
  double error_scale = 0.0;        ///< a pixel's error, or flicker, at the maps' maximum
};

/// flicker.csv: a header, and a line for each setting of each method.
[[nodiscard]] std::string flicker_csv(const std::vector<FlickerStudy>& studies);

/// Returns report.html for these studies, a self-contained file.
[[nodiscard]] Result<std::string> flicker_page(const std::vector<FlickerStudy>& studies,
                                               const std::vector<FlickerFigures>& figures);

/// Writes flicker.csv, flicker.json, plots/, pictures/ and report.html into a folder.
[[nodiscard]] Result<void> write_flicker_report(const std::vector<FlickerStudy>& studies,
                                                const std::string& folder);

}  // namespace asos
