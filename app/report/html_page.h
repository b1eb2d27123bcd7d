#pragma once

#include "app/report/html_text.h"
#include "app/report/pictures.h"
#include "app/report/plots.h"
#include "app/report/study_report.h"

#include <string>
#include <vector>

namespace asos {

/// The figures of a scene, in addition to its numbers.
struct SceneFigures {
  std::vector<Plot> plots;
  ScenePictures pictures;
};

/// report.html: a self-contained file. `figures` has one entry per scene. Errors: a picture that
/// cannot be read.
[[nodiscard]] Result<std::string> html_page(const StudyReport& report,
                                            const std::vector<SceneFigures>& figures);

/// Describes a machine as a list item.
[[nodiscard]] std::string machine_text(const Machine& machine);

// The sections of the page, in order.
[[nodiscard]] std::string html_summary(const StudyReport& report);
/// The part of the summary with the comparisons that ASOS does not win.
[[nodiscard]] std::string html_losses(const StudyReport& report);
[[nodiscard]] std::string html_scene(const SceneReport& scene, const SceneFigures& figures,
                                     std::size_t number, Embedder& embed);
/// A scene's pictures, error maps and split maps, two of them under a slider.
[[nodiscard]] std::string html_pictures(const SceneReport& scene, const ScenePictures& pictures,
                                        std::size_t number, Embedder& embed);
[[nodiscard]] std::string html_paper(const StudyReport& report);
[[nodiscard]] std::string html_measurement(const StudyReport& report);

}  // namespace asos
