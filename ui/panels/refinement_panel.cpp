#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace asos::ui {

void refinement_panel(Controls& controls, Previewer& previewer, bool& marks_part) {
  if (!previewer.scene() || !controls.section("Refinement", false)) return;
  Refinement& refinement = previewer.refinement();
  PreviewRender& render = previewer.render();
  const bool paused = refinement.paused(), at_limit = refinement.at_limit() && !paused;
  const bool going = !render.progress().finished && refinement.rest() != PauseReason::stopped;
  const Controls::Option pause{"Pause", "Pause rendering (Space)."},
      resume{"Resume", "Continue rendering (Space)."},
      proceed{"Continue", "Refine beyond the limit (Space)."},
      stop{"Stop", "Stop rendering and keep the picture."},
      restart{"Restart", "Render from the start."};
  const int pressed = controls.buttons({at_limit ? proceed
                                        : paused ? resume
                                                 : pause,
                                        going ? stop : restart});
  if (pressed == 0) at_limit ? refinement.go_on() : refinement.set_paused(!paused);
  if (pressed == 1) going ? render.stop() : render.start_again();

  if (!render.preferred().empty()) {
    if (controls.button("Refine all", "Refine the whole picture again (Z).", -1.0f))
      render.prefer({});
  } else if (controls.button(marks_part ? "Drag a rectangle in the picture" : "Refine a part first",
                             "Drag a rectangle in the picture: it becomes final before the rest. "
                             "Z refines the part under the pointer.",
                             -1.0f)) {
    marks_part = !marks_part;
  }
  RefinementLimits& limits = refinement.limits();
  controls.number("Time limit",
                  "Render time in seconds before pausing; 0: none. Ctrl+click to type a value.",
                  limits.seconds, {{0.0, RefinementLimits::most_seconds, 0.0}, 0.1, false},
                  [](double s) { return s > 0.0 ? fmt::format("{:.4g} s", s) : "none"; });
  controls.number("Quality goal",
                  "Estimated RMSE at which rendering pauses, 0 to 1; 0: none. 0.002 is half an "
                  "8-bit step. Ctrl+click to type a value.",
                  limits.rmse, {{0.0, 1.0, 0.0}, 0.0001, true},
                  [](double e) { return e > 0.0 ? fmt::format("RMSE {:.3g}", e) : "none"; });
  const std::optional<double> rmse = render.estimated_rmse();
  controls.row("Estimated error",
               render.progress().finished ? std::string("n/a (finished)")
               : rmse                     ? fmt::format("RMSE {:.2g}", *rmse)
                                          : std::string("not known yet"),
               "Estimated RMSE of the current picture, extrapolated from finished pixels.");
}

}  // namespace asos::ui
