#pragma once

#include "ui/panels/controls.h"
#include "ui/panels/study_plot.h"
#include "ui/previewer.h"
#include "ui/view_study.h"

#include <set>
#include <string>

namespace asos::ui {

/// The settings of a study of the view.
struct StudyChoice {
  std::set<std::string> rivals{"sobol", "stochastic"};  ///< compared with asos
  int budget_seconds = 30;                              ///< for the reference
  int repetitions = 3;
  int reduction = 2;      ///< divisor of the picture's width and height: 1, 2 or 4
  bool automatic = true;  ///< choose size and repetitions to take `automatic_seconds`
  static constexpr double automatic_seconds = 60.0;
  std::string error;      ///< why the last study could not start
  std::string said;       ///< message about an exported file, for the status line
  bool enlarged = false;  ///< the plot fills the window
  StudyCurves curves = StudyCurves::finished;  ///< in the plot
};

/// The plan of a study of a view of `scene_name`. Takes size, sky, reflections and TR from the
/// settings. With `automatic`, the size is the window's and reduced later.
[[nodiscard]] StudyPlan plan_of(const StudyChoice& choice, const std::string& scene_name,
                                const RenderSettings& shown);

/// "over 12": a lower bound, rounded down to two digits or to a whole number.
[[nodiscard]] std::string over_words(double factor);

/// Call once a frame, whether the panel is shown or not. The study pauses while the window renders
/// or other work uses the processors, and ends when another scene is opened.
void update_study(ViewStudy& study, const Previewer& previewer, bool other_work);

/// Starts and stops a study of the current view, and plots error against run time while it runs.
void study_panel(Controls& controls, StudyChoice& choice, ViewStudy& study,
                 const Previewer& previewer);

}  // namespace asos::ui
