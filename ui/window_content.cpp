#include "ui/window_content.h"

#include "renderer/comparison/method.h"
#include "ui/panels/pixel_place.h"
#include "ui/panels/side_panel.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/tour_panel.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

constexpr ImGuiWindowFlags fixed_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
    ImGuiWindowFlags_NoFocusOnAppearing;
constexpr int most_frames_without_input = 3;

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
    : previewer_(previewer),
      display_(std::move(display)),
      context_(context),
      saver_(previewer_, display_) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would keep an idle window awake
  InputQueue::map_keys(io);
}

WindowContent::~WindowContent() {
  ImGui::SetCurrentContext(context_);
  if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void WindowContent::draw(const FrameInput& in) {
  ImGui::SetCurrentContext(context_);
  if (!input_.empty() || state_.screenshot_requested) settle();
  settling_frames_ = std::max(0, settling_frames_ - 1);
  take_outcomes();
  previewer_.show_by(state_.display.tone);
  previewer_.show_layer(state_.display.layer);
  previewer_.update(in.time_seconds);
  update_study(study_, previewer_, check_.busy() || equal_time_.busy());
  if (in.window_size.x <= 0 || in.window_size.y <= 0 || in.framebuffer_size.x <= 0 ||
      in.framebuffer_size.y <= 0) {
    previewer_.viewpoint().set_picture_size(0, 0, in.time_seconds);
    time_seconds_ = in.time_seconds;
    return;
  }

  state_.split_share = shown_split_share(previewer_, forecast_.of(previewer_));
  progress_.update(previewer_.render().progress(), estimate(), previewer_.render().restarts(),
                   in.time_seconds);
  follow_files(in.time_seconds);
  unsaved_.update(previewer_);
  begin_frame(in);
  // Activities that start or end change the layout, which needs more than one frame to settle.
  const std::uint32_t activity_now = activity();
  if (std::exchange(shown_activity_, activity_now) != activity_now) settle();
  lay_out(in);
  ImGui::Render();

  keep_history(in.time_seconds);
  forecast_.follow(previewer_);
  // Edits by the widgets take effect in this frame, before it is presented.
  previewer_.viewpoint().set_picture_size(picture_rect_.width, picture_rect_.height,
                                          in.time_seconds);
  previewer_.show_by(state_.display.tone);
  previewer_.show_layer(state_.display.layer);
  previewer_.update(in.time_seconds);
  update_study(study_, previewer_, check_.busy() || equal_time_.busy());
  inspector_.update(previewer_, state_.picked, state_.show_boundaries);
  const auto looked =
      split_search_.update(previewer_, state_.tour.card && *state_.tour.card <= Tour::Card::split);
  state_.tour.found = looked.pixel;
  state_.tour.none_split = looked.none_split;
  // A running study measures times, so the check of splits waits for it.
  check_.update(previewer_, wants_reference() && !equal_time_.busy(), state_.check.alarm,
                study_.busy());
  error_reference_.update(previewer_, check_.findings());
  state_.frames.reference = {error_reference_.shared(), error_reference_.samples(),
                             error_reference_.revision()};
  surfaces_.update(previewer_, state_.surfaces);
  update_display();
  explain_max();
  keep_saving();
  present(in);
  save_window(in);
}

// Records undo steps. Cards of the tour add none; all edits during the tour are one step.
void WindowContent::keep_history(double now_seconds) {
  const bool touring = state_.tour.card.has_value();
  const DisplaySettings display = display_without_card(state_);
  if (touring && !history_.grouped()) history_.begin_group(previewer_, display);
  if (!touring && touring_) history_.end_group(previewer_, display);
  touring_ = touring;
  history_.update(previewer_, display, ImGui::IsAnyMouseDown(), now_seconds);
}

// Takes over the results of other threads.
void WindowContent::take_outcomes() {
  update_sky(previewer_.edits(), state_.sky, sky_reader_);
  if (auto fault = std::exchange(state_.sky.fault, std::nullopt))
    previewer_.scene().report(std::move(*fault));
  update_equal_time(previewer_, state_.equal_time, equal_time_, state_.frames);
  forecast_.update();
}

void WindowContent::begin_frame(const FrameInput& in) {
  ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 window(in.window_size), framebuffer(in.framebuffer_size);
  const float raster = framebuffer.y / window.y;
  const float content = std::isfinite(in.content_scale) ? in.content_scale : 1.0f;
  const float asked = std::clamp(state_.look.scale * content / raster, 0.5f, 8.0f);
  const float text = fitting_text_scale(asked, window.x);
  if (const theme::Appearance wanted{state_.look.theme, text, raster}; applied_ != wanted) {
    applied_ = wanted;
    theme::apply(wanted);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    settle();
  }
  io.DisplaySize = {window.x, window.y};
  io.DisplayFramebufferScale = {framebuffer.x / window.x, raster};
  io.DeltaTime = std::max(1e-4f, static_cast<float>(in.time_seconds - time_seconds_));
  time_seconds_ = in.time_seconds;
  if (!awaits_search()) input_.feed(io);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  controls_.begin_frame(in.time_seconds);
}

// After Ctrl+F the search field gets the keyboard two frames later. Keys wait for it meanwhile, so
// that none of them is a shortcut.
bool WindowContent::awaits_search() {
  if (ImGui::GetIO().WantTextInput) frames_without_input_ = 0;
  if (frames_without_input_ == 0) return false;
  --frames_without_input_;
  return true;
}

void WindowContent::lay_out(const FrameInput& in) {
  handle_shortcuts(state_, previewer_);
  if (state_.focus_search) frames_without_input_ = most_frames_without_input;
  if (!ImGui::GetIO().WantTextInput && shortcut_pressed(Key::z, true)) take_back();
  if (in.time_seconds >= state_.message_until_seconds) state_.message.clear();

  const glm::vec2 window(in.window_size);
  const float em = ImGui::GetFontSize();
  layout_ = WindowLayout::of(window, em, state_.show_panel, state_.look.show_bar,
                             previewer_.playback().available());
  if (state_.tour.card && !has_room_for_tour(layout_, em))
    layout_ = WindowLayout::of(window, em, false, false);
  state_.bar = bar_parts(layout_.bar.size);
  state_.bar.timeline = layout_.timeline.size.y > 0.0f;
  const WindowRect& picture = layout_.picture;
  const glm::vec2 scale = glm::vec2(in.framebuffer_size) / window;
  const glm::ivec2 pixels(glm::round(picture.size * scale));
  picture_rect_ = {0, 0, pixels.x, pixels.y};
  state_.view.set_sizes(pixels, {display_.width(), display_.height()});

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  begin_fixed("picture area", picture,
              ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                  ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
  // Keys go to the picture until the panel is focused.
  if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
  const PictureArea shown{picture, scale.y};
  select_at(previewer_, state_.outline, state_.pointed());
  // The tour's cards pick pixels, and mean no objects.
  outline_.update(previewer_, state_.tour.card
                                  ? std::vector<int>()
                                  : selected_objects(previewer_.scene(), state_.outline));
  if (marks_splits()) check_marks(check_.findings(), state_.check, state_.view, shown);
  draw_runs(outline_.runs(), theme::rgb(theme::accent_bright), state_.view, shown);
  if (max_.effect()) max_marks(*max_.effect(), state_.view, shown);
  picked_mark(inspector_.report(), state_, shown);
  if (state_.display.show_grid) grid_.draw(previewer_, state_.view, shown);
  if (!state_.display.show_split_map && !state_.shows_layer() &&
      state_.frames.comparison != Comparison::wipe && !state_.frames.cover_picture())
    pixel_numbers(controls_, previewer_.render().film(), state_.display.transform(), state_.view,
                  shown);
  light_marks(controls_, previewer_, state_.lights, state_.view, shown);
  wipe_line(controls_, state_.frames, state_.view, previewer_, shown);
  loading_box(previewer_, shown);
  play_button(controls_, previewer_.playback(), picture);
  if (state_.display.show_axes) axes_widget(controls_, previewer_.viewpoint(), shown);
  first_part_mark(controls_, previewer_.render(), state_.view, shown);
  if (state_.display.show_scale) scale_bar(controls_, previewer_, state_.view, shown);
  picture_area(controls_, previewer_, state_, shown);
  ImGui::End();
  ImGui::PopStyleVar();

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.8f * em, 0.42f * em});
  begin_fixed("status", layout_.status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav);
  progress_panel(
      controls_, previewer_,
      {state_.message, state_.view.zoom(), state_.hovered, state_.display.transform(),
       progress_.fraction(),
       state_.hovered ? surface_names(previewer_, *state_.hovered).joined() : std::string(),
       hovered_layer()});
  ImGui::End();
  ImGui::PopStyleVar();

  if (layout_.timeline.size.y > 0.0f) {
    begin_fixed("timeline", layout_.timeline, ImGuiWindowFlags_NoScrollbar);
    timeline_row(controls_, previewer_.playback());
    ImGui::End();
  }
  if (layout_.bar.size.y > 0.0f) {
    begin_fixed("picture bar", layout_.bar, ImGuiWindowFlags_NoScrollbar);
    picture_bar(controls_, previewer_, state_);
    ImGui::End();
  }
  if (layout_.panel.size.x > 0.0f && layout_.panel.size.y > 0.0f) panel_window(layout_.panel);
  pixel_panel(controls_, previewer_, state_,
              {inspector_.report(), check_.findings(),
               state_.picked ? surface_names(previewer_, *state_.picked) : SurfaceNames{}},
              shown);
  DisplaySettings legend = state_.display;
  const bool shows_layer = state_.display.layer && layers_.film() && !state_.surfaces.property;
  const bool compares = state_.frames.cover_picture() && !state_.shows_layer();
  if (compares || state_.shows_layer()) legend.show_legend = false;
  // The legend is hidden in pictures narrower than this if the tour's card or the pixel panel is
  // shown.
  constexpr float beside_another_em = 52.0f;
  const std::optional<PixelPlace> explained = picked_place(state_, shown, em);
  const bool panel_left = explained && explained->side == PixelPlace::Side::left;
  const bool panel_over =
      explained && (panel_left || explained->side == PixelPlace::Side::below_pixel);
  if ((state_.tour.card || panel_over) && picture.size.x < beside_another_em * em)
    legend.show_legend = false;
  if (state_.tour.card && panel_left) legend.show_legend = false;
  const MapFacts map{previewer_.edits().settings().asos.max_level,
                     !previewer_.render().progress().finished, state_.causes};
  if (split_legend(controls_, legend, map, picture, panel_left)) explain_a_pixel();
  if (shows_layer && state_.display.show_legend)
    layer_legend(controls_,
                 {*state_.display.layer, layers_.scale(),
                  renders_layer(previewer_.render().settings().method, *state_.display.layer)},
                 picture);
  if (compares && (state_.display.show_legend || state_.frames.comparison == Comparison::error))
    comparison_legend(controls_, state_.frames,
                      {error_reference_.film() ? error_reference_.samples() : 0,
                       previewer_.render().progress().finished,
                       error_reference_.summary(previewer_, state_.display.transform())},
                      picture);
  tour_panel(controls_, previewer_, state_, equal_time_, shown, in.time_seconds);
  notices(controls_, previewer_.scene(), picture);
  dialogs(picture);
}

std::string WindowContent::hovered_layer() const {
  const Film& film = previewer_.render().film();
  const auto& at = state_.hovered;
  if (!previewer_.scene() || !at || !layers_.film() || !state_.display.layer ||
      at->x >= film.width || at->y >= film.height)
    return {};
  const Layer layer = *state_.display.layer;
  const World& world = previewer_.scene()->world();
  const auto name = [&](std::uint32_t id) {
    if (layer == Layer::object) return id < world.parts.size() ? world.parts[id].name : "";
    return id < world.materials.size() ? world.materials[id].name : "";
  };
  return layer_words(film, layer, film.index(at->x, at->y), name);
}

void WindowContent::explain_a_pixel() {
  state_.picked = most_split_pixel(previewer_.render().film());
  state_.picked_pyray = -1;
  state_.shown_level.reset();
  state_.clicked = state_.picked;
  if (!state_.picked) say("No pixel is split");
}

// Marks and describes the effect of MAX while the pointer rests on its slider or drags it.
void WindowContent::explain_max() {
  MaxTurn& turn = state_.max_turn;
  const bool asked = std::exchange(turn.turned, false);
  if (!max_.update(previewer_.render(), state_.display.transform(), asked)) return;
  turn.words =
      max_.effect() ? max_words(*max_.effect(), previewer_.render().settings().asos.max_level) : "";
  settle();
}

void WindowContent::dialogs(const WindowRect& picture) {
  help_overlay(controls_, state_, picture);
  open_dialog(controls_, state_, previewer_);
  const Film& film = previewer_.render().film();
  if (state_.save.show && state_.save.stem.empty() && previewer_.scene())
    state_.save.stem =
        free_stem(screenshot_folder(), screenshot_stem(previewer_.scene()->geometry->source));
  save_dialog(controls_, state_.save,
              {{film.width, film.height}, clip_seconds(previewer_.playback())});
  if (state_.save_scene.show && state_.save_scene.path.empty() && previewer_.scene())
    state_.save_scene.path =
        free_stem(screenshot_folder(), screenshot_stem(previewer_.scene()->geometry->source),
                  {".glb"}) +
        ".glb";
  save_scene_dialog(controls_, state_.save_scene, previewer_.scene().hides());
  if (saving_notice(controls_, saver_.job(), picture)) say(saver_.stop());
  const bool saving = saver_.job().pending();
  if (!state_.said.empty()) say(std::exchange(state_.said, {}));
  quit_dialog(controls_, state_.leaving, unsaved_.lines(previewer_, state_.frames, saver_.job()),
              saving);
  open_question(controls_, previewer_.scene(), state_.opening, unsaved_.edits(previewer_));
  state_.popup_was_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

// Moves the keyboard focus to the panel's first row, which shows a frame, or back to the picture.
void WindowContent::focus_panel() {
  const bool there = ImGui::IsWindowFocused() && ImGui::GetIO().NavVisible;
  ImGui::SetWindowFocus(there ? "picture area" : "panel");
  if (!there) ImGui::SetKeyboardFocusHere();
  settle();
}

void WindowContent::take_back() {
  const bool again = ImGui::GetIO().KeyShift;
  DisplaySettings display = display_without_card(state_);
  const auto done = again ? history_.redo(previewer_, display) : history_.undo(previewer_, display);
  state_.display = display_with_card(state_, display);
  if (done)
    say((again ? "Redone: " : "Undone: ") + *done);
  else
    say(again ? "Nothing to redo" : "Nothing to undo");
}

void WindowContent::panel_window(const WindowRect& rect) {
  begin_fixed("panel", rect);
  if (std::exchange(state_.focus_panel, false)) focus_panel();
  side_panel(controls_, previewer_, state_, {forecast_, sky_reader_, equal_time_, check_, study_});
  scroll_anchor_.hold(controls_);
  ImGui::End();
  if (std::exchange(state_.forget, false)) apply(StoredSettings{});
}

// Whether pixels that the check has found are marked in the picture.
bool WindowContent::marks_splits() const {
  return state_.check.check && state_.frames.with == CompareWith::reference &&
         in_object_space(previewer_.render().settings().method);
}

// Returns whether a reference has to be sampled: to mark splits, or until that of a comparison is
// complete.
bool WindowContent::wants_reference() const {
  constexpr int whole = SplitCheck::most_passes * SplitCheck::samples_each;
  const bool has = error_reference_.film() && error_reference_.samples() >= whole;
  const Frames& frames = state_.frames;
  return marks_splits() ||
         (frames.with == CompareWith::reference && frames.comparison != Comparison::none && !has);
}

std::optional<TimeEstimate> WindowContent::estimate() const {
  return time_estimate(previewer_, forecast_.of(previewer_));
}

}  // namespace asos::ui
