#pragma once

#include "ui/panels/controls.h"
#include "ui/panels/study_plot.h"
#include "ui/previewer.h"
#include "ui/view_study.h"

#include <set>
#include <string>

namespace asos::ui {

/// The choices for a study of the view.
struct StudyChoice {
  std::set<std::string> rivals{"sobol", "stochastic"};  ///< beside asos
  int budget_seconds = 30;                              ///< for the reference
  int repetitions = 3;
  int reduction = 2;      ///< the picture's width and height are divided by it: 1, 2 or 4
  bool automatic = true;  ///< size and repetitions are chosen for `automatic_seconds`
  static constexpr double automatic_seconds = 60.0;
  std::string error;                           ///< why the last study could not start
  std::string said;                            ///< what became of a file, for the status line
  bool enlarged = false;                       ///< the plot fills the window
  StudyCurves curves = StudyCurves::finished;  ///< in the plot
};

/// The plan for a view of `scene_name` that is shown with these settings, of which size, sky,
/// reflections and TR count; at the window's size where that is chosen later.
[[nodiscard]] StudyPlan plan_of(const StudyChoice& choice, const std::string& scene_name,
                                const RenderSettings& shown);

/// Call once a frame, whether the panel is shown or not: the study rests while the window renders,
/// or other work takes the processors, and ends when another scene takes the place of its own.
void update_study(ViewStudy& study, const Previewer& previewer, bool other_work);

/// Starts and stops a study of the current view, and shows error against run time as it goes on.
void study_panel(Controls& controls, StudyChoice& choice, ViewStudy& study,
                 const Previewer& previewer);

}  // namespace asos::ui
