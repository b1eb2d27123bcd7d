#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <optional>
#include <string>

namespace asos {

void refinement_panel(Controls& controls, Previewer& previewer) {
  if (!previewer.scene() || !controls.section("Refinement", false)) return;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  Refinement& refinement = previewer.refinement();
  PreviewRender& render = previewer.render();
  const bool paused = refinement.paused();
  if (refinement.at_limit() && !paused) {
    if (controls.button("Go on",
                        "Refine beyond the limit: for as long again, or to the end where the "
                        "quality was reached. Key: Space.",
                        width))
      refinement.go_on();
  } else if (controls.button(
                 paused ? "Resume" : "Pause",
                 paused ? "Go on from where it rests. Key: Space."
                        : "Let the render rest. Changes still show their coarse picture. Key: "
                          "Space.",
                 width)) {
    refinement.set_paused(!paused);
  }
  ImGui::SameLine();
  const bool going = !render.progress().finished && refinement.rest() != Rest::stopped;
  if (controls.button(going ? "Stop" : "Render again",
                      going ? "End the render; the picture stays as it is." : "Begin anew.", width))
    going ? render.stop() : render.start_again();

  RefinementLimits& limits = refinement.limits();
  controls.number("Time limit",
                  "Seconds of rendering after which a render rests, without pauses; 0: none. "
                  "Ctrl+click to type a value.",
                  limits.seconds, {{0.0, RefinementLimits::most_seconds, 0.0}, 0.1, false},
                  [](double s) { return s > 0.0 ? fmt::format("{:.4g} s", s) : "none"; });
  controls.number(
      "Quality goal",
      "The estimated error at which a render rests: root mean square difference from "
      "the finished picture, linear values, 0 to 1; 0: none. 0.002 is half a step of an "
      "8-bit picture. Ctrl+click to type a value.",
      limits.rmse, {{0.0, 1.0, 0.0}, 0.0001, true},
      [](double e) { return e > 0.0 ? fmt::format("RMSE {:.3g}", e) : "to the end"; });
  const std::optional<double> rmse = render.estimated_rmse();
  controls.row("Estimated error",
               render.progress().finished ? std::string("n/a: finished")
               : rmse                     ? fmt::format("RMSE {:.2g}", *rmse)
                                          : std::string("not known yet"),
               "How far the picture is from the finished one, taking the pixels that are left for "
               "as wrong as those that are finished were in the coarse picture.");
}

}  // namespace asos
