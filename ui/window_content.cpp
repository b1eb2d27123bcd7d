#include "ui/window_content.h"

#include "renderer/picture/picture_text.h"
#include "ui/gl/read_framebuffer.h"
#include "ui/panels/panels.h"
#include "ui/panels/study_panel.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <filesystem>
#include <utility>

namespace asos {

namespace {

constexpr ImGuiWindowFlags fixed_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
    ImGuiWindowFlags_NoNav;
constexpr double message_seconds = 6.0;
constexpr int frames_to_settle = 3;
constexpr double dialog_fades_seconds = 0.3;
// Seldom: what drawing takes is counted as the study's.
constexpr double study_redraw_seconds = 0.5;

void begin_fixed(const char* name, const WindowRect& rect, ImGuiWindowFlags flags = 0) {
  ImGui::SetNextWindowPos({rect.lo.x, rect.lo.y});
  ImGui::SetNextWindowSize({rect.size.x, rect.size.y});
  ImGui::Begin(name, nullptr, fixed_flags | flags);
}

}  // namespace

Result<std::unique_ptr<WindowContent>> WindowContent::make(Previewer& previewer) {
  Result<GlDisplay> display = GlDisplay::make();
  if (!display) return unexpected(display.error());
  ImGuiContext* context = ImGui::CreateContext();
  std::unique_ptr<WindowContent> content(
      new WindowContent(previewer, std::move(*display), context));
  if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
    return unexpected(Error{"OpenGL", "the user interface cannot draw"});
  }
  return content;
}

WindowContent::WindowContent(Previewer& previewer, GlDisplay display, ImGuiContext* context)
    : previewer_(previewer), display_(std::move(display)), context_(context) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // A blinking cursor would keep an idle window awake.
  InputQueue::map_keys(io);
}

WindowContent::~WindowContent() {
  ImGui::SetCurrentContext(context_);
  if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void WindowContent::draw(const FrameInput& in) {
  ImGui::SetCurrentContext(context_);
  if (!input_.empty() || state_.screenshot_requested) settling_frames_ = frames_to_settle;
  settling_frames_ = std::max(0, settling_frames_ - 1);
  take_outcomes();
  previewer_.update(in.time_seconds);
  update_study(study_, previewer_, check_.busy() || equal_time_.busy());
  if (in.window_size.x <= 0 || in.window_size.y <= 0 || in.framebuffer_size.x <= 0 ||
      in.framebuffer_size.y <= 0) {
    previewer_.viewpoint().set_picture_size(0, 0, in.time_seconds);
    time_seconds_ = in.time_seconds;
    return;
  }

  follow_files(in.time_seconds);
  begin_frame(in);
  lay_out(in);
  ImGui::Render();

  history_.update(previewer_, state_.display, ImGui::IsAnyMouseDown(), in.time_seconds);
  // Changes by the widgets take effect in this frame, before it is shown.
  previewer_.viewpoint().set_picture_size(picture_rect_.width, picture_rect_.height,
                                          in.time_seconds);
  previewer_.update(in.time_seconds);
  update_study(study_, previewer_, check_.busy() || equal_time_.busy());
  inspector_.update(previewer_, state_.picked, state_.show_boundaries);
  check_.update(previewer_, state_.check.check && !equal_time_.busy(), state_.check.alarm);
  const std::vector<PixelRect> changed = previewer_.render().take_changed();
  display_.update(previewer_.render().film(), changed, state_.display,
                  previewer_.edits().settings().asos.max_level);
  display_.update_compared(previewer_.render().film(), changed, state_.frames);
  if (std::exchange(state_.screenshot_requested, false)) take_screenshot();
  keep_saving();
  present(in);
  save_window(in);
}

// Takes over the results of other threads.
void WindowContent::take_outcomes() {
  update_sky(previewer_.edits().settings(), state_.sky, sky_reader_);
  update_equal_time(previewer_, state_.equal_time, equal_time_, state_.frames);
  forecast_.update();
}

void WindowContent::begin_frame(const FrameInput& in) {
  ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 window(in.window_size), framebuffer(in.framebuffer_size);
  const float raster = framebuffer.y / window.y;
  const float content = std::isfinite(in.content_scale) ? in.content_scale : 1.0f;
  const float text = std::clamp(content / raster, 0.5f, 8.0f);
  if (const glm::vec2 scales(text, raster); scales != scales_) {
    scales_ = scales;
    theme::apply(text, raster);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  io.DisplaySize = {window.x, window.y};
  io.DisplayFramebufferScale = {framebuffer.x / window.x, raster};
  io.DeltaTime = std::max(1e-4f, static_cast<float>(in.time_seconds - time_seconds_));
  time_seconds_ = in.time_seconds;
  input_.feed(io);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  controls_.begin_frame(in.time_seconds);
}

void WindowContent::lay_out(const FrameInput& in) {
  handle_shortcuts(state_, previewer_);
  if (!ImGui::GetIO().WantTextInput && shortcut_pressed(Key::z, true)) take_back();
  if (in.time_seconds >= state_.message_until_seconds) state_.message.clear();

  // The panel stands beside the picture, never over it; in a narrow window the picture comes first.
  const glm::vec2 window(in.window_size);
  const float em = ImGui::GetFontSize();
  const float panel_width =
      state_.show_panel ? std::min(std::round(theme::panel_width_em * em), 0.5f * window.x) : 0.0f;
  const float status_height = std::min(std::round(theme::status_height_em * em), 0.5f * window.y);
  const glm::vec2 picture_size =
      glm::floor(window - glm::vec2(std::floor(panel_width), status_height));
  const WindowRect picture{{0.0f, 0.0f}, picture_size};
  const glm::vec2 scale = glm::vec2(in.framebuffer_size) / window;
  const glm::ivec2 pixels(glm::round(picture_size * scale));
  picture_rect_ = {0, 0, pixels.x, pixels.y};
  state_.view.set_sizes(pixels, {display_.width(), display_.height()});

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  begin_fixed("picture area", picture,
              ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                  ImGuiWindowFlags_NoScrollWithMouse);
  const PictureArea shown{picture, scale.y};
  check_marks(check_.findings(), state_.check, state_.view, shown);
  picked_mark(inspector_.report(), state_, shown);
  light_marks(controls_, previewer_, state_.lights, state_.view, shown);
  wipe_line(controls_, state_.frames, state_.view, previewer_.render().film(), shown);
  picture_area(controls_, previewer_, state_, shown);
  ImGui::End();
  ImGui::PopStyleVar();

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.8f * em, 0.42f * em});
  begin_fixed("status", {{0.0f, picture_size.y}, {picture_size.x, window.y - picture_size.y}},
              ImGuiWindowFlags_NoScrollbar);
  progress_panel(controls_, previewer_, {state_.message, state_.view.zoom()});
  ImGui::End();
  ImGui::PopStyleVar();

  if (panel_width > 0.0f)
    panel_window({{picture_size.x, 0.0f}, {window.x - picture_size.x, window.y}});
  pixel_panel(controls_, previewer_, state_, {inspector_.report(), check_.findings()}, shown);
  notices(controls_, previewer_.scene(), picture);
  help_overlay(state_, picture);
  open_dialog(controls_, state_, previewer_);
  const Film& film = previewer_.render().film();
  if (state_.save.show && state_.save.stem.empty() && previewer_.scene())
    state_.save.stem =
        free_stem(screenshot_folder(), screenshot_stem(previewer_.scene()->geometry->source));
  save_dialog(controls_, state_.save, {film.width, film.height});
  saving_notice(controls_, picture_job_, picture);
}

StoredSettings WindowContent::stored_settings() const {
  return {state_.display, state_.show_panel, state_.lights.show_marks, state_.watch, state_.recent};
}

void WindowContent::apply(const StoredSettings& stored) {
  state_.display = stored.display;
  state_.show_panel = stored.show_panel;
  state_.lights.show_marks = stored.show_marks;
  state_.watch = stored.watch;
  state_.recent = stored.recent;
}

// Remembers what was opened, and loads again what has changed.
void WindowContent::follow_files(double now_seconds) {
  const RenderScene* scene = previewer_.scene().get();
  if (!scene) return;
  if (scenes_seen_ != previewer_.scene().times_opened()) {
    scenes_seen_ = previewer_.scene().times_opened();
    StoredSettings stored = stored_settings();
    stored.add_recent(scene->geometry->source);
    state_.recent = std::move(stored.recent);
    state_.lights.selected = -1;
    if (const auto opened = previewer_.scene().take_opened_display())
      show_as(*opened, state_.display);
  }
  if (state_.watch && !previewer_.scene().loading() &&
      watch_.changed(previewer_.scene().files(), now_seconds))
    previewer_.scene().reload();
}

void WindowContent::take_back() {
  const bool again = ImGui::GetIO().KeyShift;
  const bool done =
      again ? history_.redo(previewer_, state_.display) : history_.undo(previewer_, state_.display);
  if (!done) say(again ? "Nothing to do again" : "Nothing to undo");
}

void WindowContent::panel_window(const WindowRect& rect) {
  begin_fixed("panel", rect);
  const RenderScene* scene = previewer_.scene().get();
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(scene ? screenshot_stem(scene->geometry->source).c_str() : "ASOS");
  ImGui::PopTextWrapPos();
  if (scene) controls_.placed("Source", scene->geometry->source.c_str());

  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (controls_.button("Open...", "Open another scene. Ctrl+O, or drop a file on the window.",
                       width)) {
    state_.show_open = true;
  }
  ImGui::SameLine();
  if (controls_.button("Save picture",
                       "Save the picture as PNG, with the split map where it is shown. Keys: P, "
                       "F12.",
                       width)) {
    state_.screenshot_requested = true;
  }
  if (controls_.button("Save as...",
                       "Save as EXR, at another size, or with the window. Key: Ctrl+S.", width))
    state_.save.show = true;
  // A built-in scene never changes.
  if (scene && !scene->geometry->source.starts_with("builtin:")) {
    if (controls_.button("Reload", "Load the file again; the view stays. Key: R.", width))
      previewer_.scene().reload();
    ImGui::SameLine();
    ImGui::Checkbox("Watch file", &state_.watch);
    controls_.placed("Watch file",
                     "Load the file again whenever it changes: looked at once a second. A file "
                     "that cannot be read leaves the scene as it is.",
                     Controls::Use::edits);
  }
  if (scene) warnings_panel(controls_, notes_of(*scene));
  antialiasing_panel(controls_, previewer_, forecast_);
  refinement_panel(controls_, previewer_);
  lights_panel(controls_, previewer_, state_.lights, state_.picked);
  shadows_panel(controls_, previewer_.edits().settings(), scene);
  reflections_panel(controls_, previewer_, state_.reflections, state_.picked);
  sky_panel(controls_, previewer_.edits().settings(), state_.sky, sky_reader_);
  compare_panel(controls_, previewer_, state_.frames);
  equal_time_panel(controls_, previewer_, state_.equal_time, equal_time_, state_.frames);
  check_panel(controls_, previewer_, state_.check, check_);
  display_panel(controls_, state_.display, previewer_.edits().settings().asos.max_level);
  camera_panel(controls_, previewer_);
  if (scene) {
    statistics_panel(controls_, previewer_.render().statistics(), previewer_.render().settings(),
                     *scene, previewer_.render().progress().fraction);
    study_panel(controls_, state_.study, study_, previewer_);
    scene_panel(controls_, *scene, previewer_.render().settings(),
                previewer_.scene().load_seconds());
  }
  ImGui::Spacing();
  if (controls_.button("Reset scene settings",
                       "Everything that the picture is rendered with back to how it was at first: "
                       "method, lights, shadows, reflections, sky and materials. The view stays. "
                       "Ctrl+Z brings it back.",
                       -1.0f))
    previewer_.edits().reset();
  if (controls_.button("Forget settings",
                       "Back to how the window was at first: display, panel, and no recent files. "
                       "The scene and what it is rendered with stay.",
                       -1.0f))
    apply(StoredSettings{});
  ImGui::End();
}

void WindowContent::present(const FrameInput& in) {
  gl::glDisable(GL_SCISSOR_TEST);
  gl::glViewport(0, 0, in.framebuffer_size.x, in.framebuffer_size.y);
  const auto part = [](std::uint32_t shift) {
    return static_cast<float>((theme::ground >> shift) & 255u) / 255.0f;
  };
  gl::glClearColor(part(16), part(8), part(0), 1.0f);
  gl::glClear(GL_COLOR_BUFFER_BIT);
  // The film may have changed its size since the layout.
  state_.view.set_sizes({picture_rect_.width, picture_rect_.height},
                        {display_.width(), display_.height()});
  display_.draw(state_.view, {picture_rect_, in.framebuffer_size.y}, state_.display, state_.frames);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void WindowContent::take_screenshot() {
  const RenderScene* scene = previewer_.scene().get();
  if (!scene || display_.width() <= 0) {
    say("There is no picture to save yet");
    return;
  }
  const RgbImage image{display_.width(), display_.height(), display_.seen_rgb(state_.display),
                       screenshot_text(previewer_, state_.display)};
  const Result<std::string> saved =
      save_screenshot(image, screenshot_folder(), screenshot_stem(scene->geometry->source));
  say(saved ? "Saved " + *saved : "Not saved: " + saved.error().message());
}

// Begins what the dialog was asked for, and tells what has come of it.
void WindowContent::keep_saving() {
  if (std::exchange(state_.save.asked, false)) begin_saving();
  if (const auto outcome = picture_job_.take_outcome())
    say(*outcome ? "Saved " + **outcome : "Not saved: " + outcome->error().message());
}

void WindowContent::begin_saving() {
  const SaveChoice choice = state_.save;
  state_.save.stem.clear();
  if (!previewer_.scene() || display_.width() <= 0) {
    say("There is no picture to save yet");
    return;
  }
  if (choice.what != SaveChoice::What::picture) {
    window_to_save_ = choice;
    save_window_seconds_ = time_seconds_ + dialog_fades_seconds;
    settling_frames_ = frames_to_settle;
    return;
  }
  Snapshot snapshot = previewer_.render().snapshot();
  if (choice.size.x > 0) {
    snapshot.settings.width = choice.size.x;
    snapshot.settings.height = choice.size.y;
  }
  DisplaySettings plain;
  plain.exposure_ev = state_.display.exposure_ev;
  const ImageText text =
      picture_text(describe(*snapshot.scene, snapshot.camera, snapshot.settings, described(plain)));
  picture_job_.start({std::move(snapshot), choice.path(), plain.exposure_ev, text});
}

// Saves the framebuffer, once the dialog has faded from it.
void WindowContent::save_window(const FrameInput& in) {
  if (!window_to_save_ || in.time_seconds < save_window_seconds_) return;
  const SaveChoice choice = *std::exchange(window_to_save_, std::nullopt);
  PixelRect area{0, 0, in.framebuffer_size.x, in.framebuffer_size.y};
  if (choice.what == SaveChoice::What::seen) area = picture_rect_;
  const RgbImage image{area.width, area.height, read_framebuffer(area, in.framebuffer_size.y),
                       screenshot_text(previewer_, state_.display)};
  const Result<void> written = write_png(choice.path(), image);
  say(written ? "Saved " + choice.path() : "Not saved: " + written.error().message());
}

void WindowContent::say(std::string message) {
  state_.message = std::move(message);
  state_.message_until_seconds = time_seconds_ + message_seconds;
  settling_frames_ = frames_to_settle;
}

std::optional<double> WindowContent::seconds_to_redraw() const {
  if (settling_frames_ > 0 || !input_.empty()) return 0.0;
  std::optional<double> due = previewer_.seconds_to_update(time_seconds_);
  const auto also = [&due](double seconds) { due = std::min(due.value_or(seconds), seconds); };
  if (const std::optional<double> step = history_.seconds_to_update(time_seconds_)) also(*step);
  if (flying()) also(0.0);
  if (inspector_.busy() || sky_reader_.busy() || forecast_.busy()) also(0.02);
  if (check_.pending() || equal_time_.pending()) also(0.1);
  if (state_.watch && previewer_.scene()) also(watch_.seconds_to_look(time_seconds_));
  if (const std::optional<double> tooltip = controls_.seconds_to_tooltip()) also(*tooltip);
  if (!state_.message.empty()) also(std::max(0.0, state_.message_until_seconds - time_seconds_));
  if (previewer_.scene().loading() || picture_job_.state()) also(0.1);
  if (window_to_save_) also(std::max(0.0, save_window_seconds_ - time_seconds_));
  if (previewer_.render().progress().running) also(0.25);
  if (previewer_.scene() && !previewer_.scene()->geometry->boundaries.known()) also(0.25);
  if (study_.busy()) also(study_redraw_seconds);
  return due;
}

}  // namespace asos
