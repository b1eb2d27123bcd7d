#include "ui/window_loop.h"

#include "ui/screenshot.h"

#include <utility>

namespace asos::ui {

WindowLoop::WindowLoop(HostWindow& window, Previewer& previewer, WindowContent& content,
                       Hooks hooks)
    : window_(window),
      previewer_(previewer),
      content_(content),
      hooks_(std::move(hooks)),
      saved_(content.stored_settings()) {
  saved_.window_size = window.plain_size();
}

void WindowLoop::run() {
  while (!content_.state().leaving.quit) {
    // Process events even if a frame takes longer than the time to the next one.
    window_.wait(0.0);
    take_events();
    if (!window_.visible()) {
      if (content_.state().leaving.quit) break;
      window_.wait(std::nullopt);
      continue;
    }
    const double due = schedule_.due(), now = hooks_.now_seconds();
    if (now >= due) {
      draw(now);
    } else {
      window_.wait(due == DrawSchedule::never ? std::nullopt : std::optional(due - now));
    }
  }
  save();
}

void WindowLoop::take_events() {
  HostWindow::WindowEvents happened = window_.take_happened();
  if (!happened.input.empty() || happened.needs_redraw) schedule_.note_input();
  for (const InputEvent& event : happened.input) content_.input().add(event);
  if (!happened.dropped_files.empty()) {
    content_.open_dropped(happened.dropped_files.front());
    schedule_.note_input();
  }
  if (happened.asked_to_close) {
    content_.state().leaving.asked = true;
    schedule_.note_input();
  }
  if (hooks_.woken.exchange(false))
    schedule_.note_woken(previewer_.render().first_picture_pending() ||
                         previewer_.scene().loading().has_value());
}

void WindowLoop::draw(double now) {
  schedule_.begin_frame(now);
  content_.draw({window_.size(), window_.framebuffer_size(), window_.content_scale(), now});
  window_.present();
  schedule_.end_frame(hooks_.now_seconds(), content_.seconds_to_redraw());
  if (const RenderScene* scene = previewer_.scene().get();
      scene && scene->geometry->source != titled_) {
    titled_ = scene->geometry->source;
    save();
    window_.set_title(printable(file_title(titled_)) + " - ASOS");
  }
}

// A failure to save the settings is ignored.
void WindowLoop::save() {
  StoredSettings now = content_.stored_settings();
  if (const glm::ivec2 size = window_.plain_size(); size.x > 0) now.window_size = size;
  if (now == saved_) return;
  // Another window may have saved its settings meanwhile.
  const Result<StoredSettings> theirs = load_settings(settings_path());
  if (save_settings(settings_path(), theirs ? merged(saved_, now, *theirs) : now))
    saved_ = std::move(now);
}

}  // namespace asos::ui
