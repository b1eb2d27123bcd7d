#include "renderer/files/helper_program.h"
#include "ui/movie.h"
#include "ui/panels/dialog.h"
#include "ui/panels/overlay_window.h"
#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <span>

namespace asos::ui {

namespace {

struct NamedSize {
  const char* name;
  const char* tooltip;
  glm::ivec2 size;
};
constexpr std::array named_sizes{
    NamedSize{"Same as window", "The size of the picture in the window.", {0, 0}},
    NamedSize{"HD", "1920 x 1080 pixels.", {1920, 1080}},
    NamedSize{"4K", "3840 x 2160 pixels.", {3840, 2160}},
    NamedSize{"8K", "7680 x 4320 pixels.", {7680, 4320}},
};

void choose_what(Controls& controls, SaveChoice& choice, bool moves) {
  constexpr std::array options{
      Controls::Option{"Render", "The picture alone, rendered in the background at any size."},
      Controls::Option{"Viewport", "The viewport with split map, gizmos and messages."},
      Controls::Option{"Window", "The whole window."},
      Controls::Option{"Turntable", "A whole turn about the orbit centre, as frames or MP4."},
      Controls::Option{"Clip", "The chosen animation from its beginning, as frames or MP4."}};
  if (!moves && choice.what == SaveChoice::What::clip) choice.what = SaveChoice::What::picture;
  const std::span offered(options.data(), moves ? options.size() : options.size() - 1);
  controls.options("Content", offered, choice.what, {false, std::nullopt});
}

void choose_format(Controls& controls, SaveChoice& choice) {
  constexpr std::array options{
      Controls::Option{"PNG", "8 bits per channel, with exposure."},
      Controls::Option{"EXR", "Linear radiance, 32-bit floats, without exposure."}};
  controls.options("Format", options, choice.exr);
}

// Chooses the layers of the EXR.
void choose_layers(Controls& controls, SaveChoice& choice) {
  constexpr std::array options{
      Controls::Option{"None", "The picture alone."},
      Controls::Option{"Shown", "The picture and the layer in the window."},
      Controls::Option{"All", "The picture with depth, normals, ids and all others."}};
  controls.options("Layers in file", options, choice.layers);
}

void choose_movie(Controls& controls, SaveChoice& choice, const SaveFacts& facts) {
  constexpr std::array options{Controls::Option{"Frames", "Numbered PNG files."},
                               Controls::Option{"MP4", "An H.264 video, made by ffmpeg."}};
  const bool joins = !find_program("ffmpeg").empty();
  choice.mp4 &= joins;
  if (joins) controls.options("Movie format", options, choice.mp4);
  if (!joins)
    controls.row("Movie format", "PNG frames. MP4 needs ffmpeg, which is not installed.",
                 "Install ffmpeg to save videos.");
  const auto whole = [](double n) { return fmt::format("{:.0f}", n); };
  if (choice.what == SaveChoice::What::turntable) {
    double frames = choice.frames;
    const Controls::Drag drag{{2.0, double{SaveChoice::most_frames}, 120.0}, 1.0, true};
    if (controls.number("Frames", "Number of frames of the turn.", frames, drag, whole))
      choice.frames = static_cast<int>(std::round(frames));
  }
  controls.number("Frame rate", "Frames per second.", choice.fps, {{1.0, 120.0, 24.0}, 0.1, true},
                  [](double fps) { return fmt::format("{:.3g} fps", fps); });
  const bool turns = choice.what == SaveChoice::What::turntable;
  const int frames = turns ? choice.frames : frames_of(facts.clip_seconds, choice.fps);
  controls.row("Length", fmt::format("{} frames, {:.1f} s", frames, frames / choice.fps));
}

// Says how a picture of another aspect ratio is framed. Always takes a line, so that nothing moves.
void shape_words(Controls& controls, glm::ivec2 size, glm::ivec2 shown) {
  const glm::dvec2 wanted(size), window(shown);
  if (shown.x <= 0 || shown.y <= 0) return;
  const double wider = wanted.x / wanted.y / (window.x / window.y);
  constexpr double visibly = 0.005;
  std::string words = "Same view as in the window.";
  if (wider > 1.0 + visibly)
    words = fmt::format("Shows {:.0f} % more at the sides.", 100.0 * (wider - 1.0));
  if (wider < 1.0 - visibly)
    words = fmt::format("Shows {:.0f} % less at the sides.", 100.0 * (1.0 - wider));
  controls.dim_text("Shape", words);
}

void choose_size(Controls& controls, SaveChoice& choice, glm::ivec2 shown) {
  std::array<Controls::Option, named_sizes.size()> options{};
  int chosen = -1;
  for (std::size_t i = 0; i < named_sizes.size(); ++i) {
    options[i] = {named_sizes[i].name, named_sizes[i].tooltip};
    if (named_sizes[i].size == choice.size) chosen = static_cast<int>(i);
  }
  if (controls.options("Size", options, chosen) && chosen >= 0)
    choice.size = named_sizes[static_cast<std::size_t>(chosen)].size;
  const glm::ivec2 size = choice.size.x > 0 ? choice.size : shown;
  glm::dvec2 typed(size);
  const Controls::Drag drag{{1.0, double{SaveChoice::largest_side}, std::nullopt}, 1.0, true};
  const auto words = [](double pixels) { return fmt::format("{:.0f}", pixels); };
  const bool across = controls.number("Width (px)", "Width in pixels.", typed.x, drag, words);
  const bool down = controls.number(
      "Height (px)", "Height in pixels. The vertical field of view stays.", typed.y, drag, words);
  if (across || down) choice.size = glm::ivec2(glm::round(typed));
  shape_words(controls, choice.size.x > 0 ? choice.size : shown, shown);
}

// Controls for the path.
void choose_file(Controls& controls, SaveChoice& choice) {
  ImGui::Spacing();
  const std::string added = choice.path().substr(choice.stem.size());
  ImGui::TextDisabled("File name (%s is added)", added.c_str());
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputText("##file", &choice.stem);
  controls.placed("File name", "Path of the file. The ending follows from the format.",
                  Controls::Use::edits);
}

}  // namespace

void save_dialog(Controls& controls, SaveChoice& choice, const SaveFacts& facts) {
  constexpr const char* title = "Save picture";
  const Dialog dialog(title, choice.show, 34.0f);
  if (!dialog.open()) return;
  choose_what(controls, choice, facts.clip_seconds > 0.0);
  if (choice.what == SaveChoice::What::picture) choose_format(controls, choice);
  if (choice.as_exr()) choose_layers(controls, choice);
  if (choice.is_movie()) choose_movie(controls, choice, facts);
  if (choice.what == SaveChoice::What::picture || choice.is_movie())
    choose_size(controls, choice, facts.shown);
  choose_file(controls, choice);
  dialog.path_words(choice.path());
  dialog.end_saving(controls, "Save", "Save in the background (Enter).", !choice.stem.empty(),
                    choice);
}

bool saving_notice(Controls& controls, const PictureJob& job, const WindowRect& area) {
  const std::optional<PictureJob::State> state = job.state();
  if (!state || area.size.x < 1.0f || area.size.y < 1.0f) return false;
  const float em = ImGui::GetFontSize();
  place_notice(area, 30.0f, 0.97f, 1.0f);
  const OverlayWindow notice("saving");
  std::string words =
      fmt::format("{}   {:.0f} %", std::filesystem::path(state->path).filename().string(),
                  std::floor(100.0 * state->fraction));
  if (state->seconds_left >= 0.0)
    words += fmt::format("   about {:.0f} s left", std::ceil(state->seconds_left));
  ImGui::TextUnformatted(words.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, {corner.x + width, corner.y + 0.2f * em},
                      theme::packed(theme::field));
  draw->AddRectFilled(
      corner, {corner.x + width * static_cast<float>(state->fraction), corner.y + 0.2f * em},
      theme::packed(theme::accent_bright));
  ImGui::Dummy({width, 0.2f * em});
  return controls.button("Stop saving", "Stop and leave no file.");
}

}  // namespace asos::ui
