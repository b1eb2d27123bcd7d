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

void transport(Controls& controls, Playback& playback, float width) {
  const bool playing = playback.playing();
  if (controls.button(
          playing ? "Pause clip" : "Play",
          playing ? "Pause; the frame is refined (Space)." : "Play the animation (Space).", width))
    playback.set_playing(!playing);
  ImGui::SameLine();
  if (controls.button("< Frame", "Back by one frame and pause.", width)) playback.step(-1);
  ImGui::SameLine();
  if (controls.button("Frame >", "Forward by one frame and pause.", width)) playback.step(1);
}

void time_slider(Controls& controls, Playback& playback) {
  const double end = playback.duration_seconds();
  if (!playback.time() || !(end > 0.0)) return;
  double seconds = playback.time()->seconds;
  if (controls.slider("Time", "Time in the animation, in seconds. Ctrl+click to type a value.",
                      seconds, {0.0, end, 0.0}, [](float s) { return fmt::format("{:.3f} s", s); }))
    playback.seek(seconds);
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

void timeline_row(Controls& controls, Playback& playback) {
  const Controls::Unlabelled unlabelled(controls);
  transport(controls, playback, 5.5f * ImGui::GetFontSize());
  ImGui::SameLine();
  time_slider(controls, playback);
}

void play_button(Controls& controls, Playback& playback, const WindowRect& picture) {
  if (!playback.available() || playback.time()) return;
  const float em = ImGui::GetFontSize(), side = 3.0f * em;
  if (picture.size.x < 4.0f * side || picture.size.y < 4.0f * side) return;
  const glm::vec2 lo =
      picture.lo + glm::vec2(0.5f * (picture.size.x - side), picture.size.y - 1.5f * side);
  ImGui::SetCursorScreenPos({lo.x, lo.y});
  if (ImGui::InvisibleButton("play", {side, side})) playback.set_playing(true);
  const bool lit = ImGui::IsItemHovered();
  controls.placed("Play on picture", "Play the file's animation (Space).", Controls::Use::edits);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 middle{lo.x + 0.5f * side, lo.y + 0.5f * side};
  draw.AddCircleFilled(middle, 0.5f * side, IM_COL32(0, 0, 0, lit ? 200 : 140), 48);
  draw.AddTriangleFilled({middle.x - 0.16f * side, middle.y - 0.23f * side},
                         {middle.x - 0.16f * side, middle.y + 0.23f * side},
                         {middle.x + 0.26f * side, middle.y}, IM_COL32(255, 255, 255, 230));
}

void timeline_panel(Controls& controls, Playback& playback, RenderSettings& settings,
                    bool under_picture) {
  if (!playback.available() || !controls.section("Animation")) return;
  clip_chooser(controls, playback);
  if (!under_picture) {
    transport(controls, playback, Controls::button_width(3));
    time_slider(controls, playback);
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
