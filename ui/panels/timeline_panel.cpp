#include "ui/panels/timeline_panel.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

namespace asos {

namespace {

void clip_chooser(Controls& controls, Playback& playback) {
  std::vector<std::string> names{"None: at rest"};
  for (const SceneContents::Animation& animation : playback.animations()) {
    const std::string name = printable(animation.name);
    names.push_back(fmt::format("{} ({:.3g} s)",
                                name.empty() ? fmt::format("Animation {}", names.size() - 1) : name,
                                animation.seconds));
  }
  int chosen = playback.time() ? playback.time()->animation + 1 : 0;
  if (controls.list("Clip",
                    "Which of the file's animations moves the scene. At rest, everything stands "
                    "where the file's nodes place it.",
                    names, chosen, 0))
    playback.choose(chosen - 1);
}

void transport(Controls& controls, Playback& playback) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * spacing) / 3.0f;
  if (controls.button("Step back",
                      "Pause, and go back by a frame, of which there are as many a second as "
                      "Frames/s says.",
                      width))
    playback.step(-1);
  ImGui::SameLine();
  const bool playing = playback.playing();
  if (controls.button(playing ? "Hold" : "Play",
                      playing ? "Hold this moment; its picture refines to the end."
                              : "Let the animation run. Each moment is shown by the passes that "
                                "there is time for.",
                      width))
    playback.set_playing(!playing);
  ImGui::SameLine();
  if (controls.button("Step on", "Pause, and go on by a frame.", width)) playback.step(1);
}

}  // namespace

void timeline_panel(Controls& controls, Playback& playback) {
  if (!playback.available() || !controls.section("Animation")) return;
  clip_chooser(controls, playback);
  transport(controls, playback);
  const double end = playback.duration_seconds();
  if (playback.time() && end > 0.0) {
    auto seconds = static_cast<float>(playback.time()->seconds);
    if (controls.slider("Time", "When in the animation. Ctrl+click to type seconds.", seconds,
                        {0.0f, static_cast<float>(end), 0.0f},
                        [](float s) { return fmt::format("{:.3f} s", s); }))
      playback.seek(static_cast<double>(seconds));
  }
  Playback::Options& options = playback.options();
  controls.checkbox("Loop", "Begin again at the end; otherwise the animation stops there.",
                    options.loop, true);
  controls.number("Speed",
                  "How fast it plays: 1 is as the file says, 0.5 half as fast. Ctrl+click to type "
                  "a value.",
                  options.speed, {{Playback::slowest, Playback::fastest, 1.0}, 0.01, true},
                  [](double s) { return fmt::format("{:.3g} x", s); });
  controls.number("Frames/s", "How long the frames of the steps are. Ctrl+click to type.",
                  options.fps, {{1.0, 1000.0, 24.0}, 0.1, true},
                  [](double f) { return fmt::format("{:.4g}", f); });
  if (playback.pose_seconds() > 0.0)
    controls.row("Posed in",
                 fmt::format("{:.1f} + {:.1f} ms", 1e3 * playback.pose_seconds(),
                             1e3 * playback.prepare_seconds()),
                 "What the last moment took before its picture began: to move the scene, and to "
                 "make it ready to render.");
}

}  // namespace asos
