#include "ui/panels/timeline_panel.h"

#include "renderer/comparison/method.h"
#include "renderer/files/printable.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr double shortest_shutter = 1e-5;

void clip_chooser(Controls& controls, Playback& playback) {
  std::vector<std::string> names{"Rest pose"};
  for (const SceneContents::Animation& animation : playback.animations()) {
    const std::string name = printable(animation.name);
    names.push_back(fmt::format("{} ({:.3g} s)",
                                name.empty() ? fmt::format("Animation {}", names.size() - 1) : name,
                                animation.seconds));
  }
  int chosen = playback.time() ? playback.time()->animation + 1 : 0;
  if (controls.list("Clip", "Animation of the file. Rest pose: the pose stored in the file.", names,
                    chosen, 0))
    playback.choose(chosen - 1);
}

void transport(Controls& controls, Playback& playback) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * spacing) / 3.0f;
  if (controls.button("< Frame", "Back by one frame and pause.", width)) playback.step(-1);
  ImGui::SameLine();
  const bool playing = playback.playing();
  if (controls.button(playing ? "Pause clip" : "Play",
                      playing ? "Pause; the frame is refined." : "Play the animation.", width))
    playback.set_playing(!playing);
  ImGui::SameLine();
  if (controls.button("Frame >", "Forward by one frame and pause.", width)) playback.step(1);
}

std::string words_of(const Playback& playback) {
  if (playback.playing()) return "When paused";
  if (!playback.time()) return "Not in the rest pose";
  const Exposure* exposure = playback.exposure();
  if (playback.posing() || !exposure) return "Posing...";
  if (!exposure->moves()) return "Nothing moves";
  return fmt::format("{} steps{}", exposure->steps(), exposure->limited ? ", limited" : "");
}

void shutter_controls(Controls& controls, const Playback& playback, double fps,
                      RenderSettings& settings) {
  bool on = settings.shutter.blurs();
  if (controls.checkbox("Motion blur", "Blur what moves while the shutter is open.", on, false))
    settings.shutter.seconds = on ? 0.5 / fps : 0.0;
  if (!on) return;
  controls.number("Shutter", "Time that the shutter is open, in seconds.", settings.shutter.seconds,
                  {{shortest_shutter, ShutterSettings::longest, 0.5 / fps}, 1e-4, true},
                  [](double s) { return fmt::format("{:.4g} s", s); });
  if (row_of(settings.method).takes_motion)
    controls.row("Blur", words_of(playback), "Steps that the exposure is split into.");
  else
    controls.row("Note", "This method renders without blur.");
}

}  // namespace

void timeline_panel(Controls& controls, Playback& playback, RenderSettings& settings) {
  if (!playback.available() || !controls.section("Animation")) return;
  clip_chooser(controls, playback);
  transport(controls, playback);
  const double end = playback.duration_seconds();
  if (playback.time() && end > 0.0) {
    auto seconds = static_cast<float>(playback.time()->seconds);
    if (controls.slider("Time", "Time in the animation, in seconds. Ctrl+click to type a value.",
                        seconds, {0.0f, static_cast<float>(end), 0.0f},
                        [](float s) { return fmt::format("{:.3f} s", s); }))
      playback.seek(static_cast<double>(seconds));
  }
  Playback::Options& options = playback.options();
  controls.checkbox("Loop", "Repeat from the start.", options.loop, true);
  controls.number("Speed", "Playback speed; 1 is normal. Ctrl+click to type a value.",
                  options.speed, {{Playback::slowest, Playback::fastest, 1.0}, 0.01, true},
                  [](double s) { return fmt::format("{:.3g} x", s); });
  controls.number("Frames/s", "Frames per second of single steps. Ctrl+click to type a value.",
                  options.fps, {{1.0, 1000.0, 24.0}, 0.1, true},
                  [](double f) { return fmt::format("{:.4g}", f); });
  shutter_controls(controls, playback, options.fps, settings);
  if (playback.pose_seconds() > 0.0)
    controls.row("Update",
                 fmt::format("Pose {:.1f} ms, edges {:.1f} ms", 1e3 * playback.pose_seconds(),
                             1e3 * playback.prepare_seconds()),
                 "Time to pose the scene and to prepare it for rendering.");
}

}  // namespace asos::ui
