#include "ui/gl/read_framebuffer.h"
#include "ui/theme.h"
#include "ui/window_content.h"

#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>
#include <utility>
#include <vector>

// The part of WindowContent that displays and saves the picture.

namespace asos::ui {

// A change of EPS or MAX ends the display of the previous picture.
void WindowContent::update_display() {
  const PreviewRender& render = previewer_.render();
  const PreviewRender::FinishedPicture* before = render.finished_before();
  if (std::exchange(restarts_seen_, render.restarts()) != render.restarts() || !before)
    state_.show_before = false;
  std::vector<PixelRect> changed = previewer_.render().take_changed();
  if (!changed.empty()) state_.causes = count_causes(render.film());
  const SurfacePicture* surfaces = surfaces_.picture();
  const bool shows_surfaces = surfaces && state_.surfaces.property;
  layers_.update(render.film(), changed, state_.display, !render.progress().finished,
                 time_seconds_);
  const bool shows_layer = layers_.film() && !shows_surfaces;
  const Film& picture = state_.show_before ? before->film : render.film();
  const Film& film = shows_surfaces ? surfaces->film : shows_layer ? *layers_.film() : picture;
  const std::uint64_t revision = shows_surfaces ? surfaces_.revision() : 0;
  const bool other_film = std::exchange(before_shown_, state_.show_before) != state_.show_before;
  const bool other_surfaces = std::exchange(surfaces_shown_, revision) != revision;
  const std::uint64_t layer = shows_layer ? layers_.revision() : 0;
  const bool other_layer = std::exchange(layer_shown_, layer) != layer;
  if (other_film || other_surfaces || other_layer) changed = {{0, 0, film.width, film.height}};
  shown_display_ = state_.display;
  if (state_.frames.comparison == Comparison::error) shown_display_.show_split_map = false;
  if (shows_surfaces || shows_layer) {
    shown_display_.exposure_ev = 0.0f;
    shown_display_.tone = ToneCurve::none;
    shown_display_.show_split_map = false;
  }
  display_.update(film, changed, shown_display_, render.map_revision());
  display_.show_wireframe(surfaces && state_.surfaces.wireframe ? surfaces : nullptr,
                          surfaces_.revision());
  display_.update_compared(film, changed, state_.frames);
}

void WindowContent::present(const FrameInput& in) {
  // The film may have changed its size since the layout.
  state_.view.set_sizes({picture_rect_.width, picture_rect_.height},
                        {display_.width(), display_.height()});
  if (!in.shown) return;
  gl::glDisable(GL_SCISSOR_TEST);
  gl::glViewport(0, 0, in.framebuffer_size.x, in.framebuffer_size.y);
  const auto part = [](std::uint32_t shift) {
    return static_cast<float>((theme::rgb(theme::ground) >> shift) & 255u) / 255.0f;
  };
  gl::glClearColor(part(16), part(8), part(0), 1.0f);
  gl::glClear(GL_COLOR_BUFFER_BIT);
  static const Frames no_frames;
  const Frames& frames = surfaces_shown_ == 0 && layer_shown_ == 0 ? state_.frames : no_frames;
  display_.draw(state_.view, {picture_rect_, in.framebuffer_size.y}, shown_display_, frames);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

// Starts requested saves and reports their results.
void WindowContent::keep_saving() {
  if (std::exchange(state_.screenshot_requested, false))
    say(saver_.save_shown(shown_display_, progress_.fraction()));
  if (std::exchange(state_.save.asked, false)) {
    const SaveChoice choice = state_.save;
    state_.save.stem.clear();
    settle();
    if (auto words = saver_.begin(choice, state_.display, time_seconds_)) say(*words);
  }
  if (auto words = saver_.take_outcome()) say(*words);
  if (const auto edits = saver_.take_saved_edits()) unsaved_.note_saved(*edits);
  keep_exporting();
  keep_copying();
}

void WindowContent::keep_exporting() {
  if (std::exchange(state_.save_scene.asked, false) && previewer_.scene()) {
    if (scene_export_.busy()) {
      say("A scene is being saved already");
    } else {
      exported_ = UnsavedWork::edits_of(previewer_);
      scene_export_.start(
          [order = order_of(previewer_, std::exchange(state_.save_scene.path, {}))](
              const std::stop_token&, const auto& tell) { tell(export_edited(order)); });
    }
  }
  const auto outcome = scene_export_.take_outcome();
  if (!outcome) return;
  say(*outcome ? "Saved " + **outcome : "Not saved: " + outcome->error().message());
  if (*outcome) unsaved_.note_exported(exported_);
}

void WindowContent::keep_copying() {
  if (std::exchange(state_.copy_requested, false)) {
    if (!previewer_.scene() || display_.width() <= 0) {
      say("No picture to copy yet");
    } else if (const auto begun =
                   copy_picture(clipboard_, {display_.width(), display_.height(),
                                             display_.seen_rgb(state_.display), ImageText{}});
               !begun) {
      say("Not copied: " + begun.error().message());
    }
  }
  if (const auto outcome = clipboard_.take_outcome())
    say(*outcome ? std::string("Copied the picture") : "Not copied: " + outcome->error().message());
}

// Saves the framebuffer once the dialog has faded out.
void WindowContent::save_window(const FrameInput& in) {
  const std::optional<SaveChoice> choice = saver_.take_due(in.time_seconds);
  if (!choice) return;
  PixelRect area{0, 0, in.framebuffer_size.x, in.framebuffer_size.y};
  if (choice->what == SaveChoice::What::seen) area = picture_rect_;
  say(saver_.save_read(
      *choice,
      {area.width, area.height, read_framebuffer(area, in.framebuffer_size.y), ImageText{}},
      state_.display));
}

}  // namespace asos::ui
