#pragma once

#include "renderer/result.h"
#include "renderer/study/analysis.h"
#include "ui/panels/study_plot.h"

#include <string>

namespace asos::ui {

/// The plot as an SVG of 800 x 560 units with its legend.
[[nodiscard]] std::string plot_svg(const StudyPlot& plot, const std::string& title);

/// The text as a cell of CSV, in quotes if it needs them.
[[nodiscard]] std::string csv_cell(const std::string& text);
/// CSV with a line for each setting, and for each picture of a watched render.
[[nodiscard]] std::string study_csv(const SceneStudy& study);

/// Writes `text` into the next free FOLDER/STEM-study-001.EXTENSION and returns its path.
[[nodiscard]] Result<std::string> save_study_text(const std::string& folder,
                                                  const std::string& stem,
                                                  const std::string& extension,
                                                  const std::string& text);

}  // namespace asos::ui
