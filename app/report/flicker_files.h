#pragma once

#include "app/report/flicker_study.h"
#include "app/report/gnuplot.h"
#include "renderer/result.h"

#include <string>
#include <vector>

namespace asos {

/// A method's film strip: PNG files that hold the frames side by side.
struct ShownStrip {
  std::string label;
  std::string frames;
  std::string errors;   ///< of each frame; empty for the reference
  std::string flicker;  ///< of the whole picture; empty for the reference
  const FlickerPoint* point = nullptr;
};

/// The figures of a study, as files.
struct FlickerFigures {
  std::vector<std::string> plots;  ///< their files without endings; may be empty
  std::vector<ShownStrip> strips;  ///< the reference first
  double error_scale = 0.0;  ///< a pixel's error, or flicker, that maps show at their brightest
};

/// The points that are shown side by side: the anchor, and of each other method the one that takes
/// most nearly as long.
[[nodiscard]] std::vector<const FlickerPoint*> shown_points(const FlickerStudy& study);

/// flicker.csv: a header, and a line for each setting of each method.
[[nodiscard]] std::string flicker_csv(const std::vector<FlickerStudy>& studies);

/// report.html of such studies: one file that asks for nothing else.
[[nodiscard]] Result<std::string> flicker_page(const std::vector<FlickerStudy>& studies,
                                               const std::vector<FlickerFigures>& figures);

/// Writes flicker.csv, flicker.json, plots/, pictures/ and report.html into a folder.
[[nodiscard]] Result<void> write_flicker_report(const std::vector<FlickerStudy>& studies,
                                                const std::string& folder);

}  // namespace asos
