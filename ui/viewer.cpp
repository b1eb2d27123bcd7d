#include "ui/viewer.h"

#include "renderer/comparison/method.h"
#include "ui/draw_schedule.h"
#include "ui/previewer.h"
#include "ui/screenshot.h"
#include "ui/stored_settings.h"
#include "ui/theme.h"
#include "ui/window.h"
#include "ui/window_content.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace asos {

namespace {

double now_seconds() {
  using Clock = std::chrono::steady_clock;
  static const Clock::time_point start = Clock::now();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

glm::ivec2 window_size_for(const RenderSettings& settings) {
  const float panel = std::round(theme::panel_width_em * theme::text_pixels);
  const float status = std::round(theme::status_height_em * theme::text_pixels);
  return {settings.width + static_cast<int>(panel), settings.height + static_cast<int>(status)};
}

/// Decides when to draw and when to sleep: nothing is drawn while nothing changes.
class Loop {
 public:
  Loop(Window& window, Previewer& previewer, WindowContent& content, std::atomic<bool>& woken)
      : window_(window),
        previewer_(previewer),
        content_(content),
        woken_(woken),
        saved_(content.stored_settings()) {
    saved_.window_size = window.plain_size();
  }

  void run() {
    while (!content_.state().leaving.quit) {
      // Frames may take longer than the time between them: who only drew would hear nothing.
      window_.wait(0.0);
      take_events();
      if (!window_.visible()) {
        if (content_.state().leaving.quit) break;
        window_.wait(std::nullopt);
        continue;
      }
      const double due = schedule_.due(), now = now_seconds();
      if (now >= due) {
        draw(now);
      } else {
        window_.wait(due == DrawSchedule::never ? std::nullopt : std::optional(due - now));
      }
    }
    save();
  }

 private:
  void take_events() {
    Window::Happened happened = window_.take_happened();
    if (!happened.input.empty() || happened.needs_redraw) schedule_.note_input();
    for (const InputEvent& event : happened.input) content_.input().add(event);
    if (!happened.dropped_files.empty()) {
      previewer_.scene().open(happened.dropped_files.front());
      schedule_.note_input();
    }
    if (happened.asked_to_close) {
      content_.state().leaving.asked = true;
      schedule_.note_input();
    }
    if (woken_.exchange(false)) schedule_.note_woken(previewer_.render().first_picture_pending());
  }

  void draw(double now) {
    schedule_.begin_frame(now);
    content_.draw({window_.size(), window_.framebuffer_size(), window_.content_scale(), now});
    window_.present();
    schedule_.end_frame(content_.seconds_to_redraw());
    if (const RenderScene* scene = previewer_.scene().get();
        scene && scene->geometry->source != titled_) {
      titled_ = scene->geometry->source;
      save();
      window_.set_title(printable(screenshot_stem(titled_)) + " - ASOS");
    }
  }

  // Settings that cannot be kept are no reason to disturb anybody.
  void save() {
    StoredSettings now = content_.stored_settings();
    if (const glm::ivec2 size = window_.plain_size(); size.x > 0) now.window_size = size;
    if (now == saved_) return;
    // Another window may have saved its own meanwhile.
    const Result<StoredSettings> theirs = load_settings(settings_path());
    if (save_settings(settings_path(), theirs ? merged(saved_, now, *theirs) : now))
      saved_ = std::move(now);
  }

  Window& window_;
  Previewer& previewer_;
  WindowContent& content_;
  std::atomic<bool>& woken_;
  StoredSettings saved_;
  std::string titled_;
  DrawSchedule schedule_;
};

}  // namespace

int run_viewer(const ViewerOptions& options) {
  const auto fail = [](const Error& error) {
    std::fputs(fmt::format("asos: cannot open a window: {}\n", error.message()).c_str(), stderr);
    return 1;
  };
  const Result<StoredSettings> stored = load_settings(settings_path());
  RenderSettings settings = options.settings;
  glm::ivec2 size = window_size_for(settings);
  if (stored && !options.own_size && stored->window_size.x > 0) size = stored->window_size;
  // A method that only some scenes can be rendered by would begin with an error.
  if (stored && !options.own_method && !row_of(stored->method).limited())
    settings.method = stored->method;
  const Result<std::unique_ptr<Window>> window = Window::open("ASOS", size);
  if (!window) return fail(window.error());

  std::atomic<bool> woken = false;
  const auto wake = [&woken] {
    woken = true;
    Window::wake();
  };
  Previewer previewer({{}, wake, options.forced}, settings);
  if (options.own_sky) previewer.edits().keep_first_sky();
  const Result<std::unique_ptr<WindowContent>> content = WindowContent::make(previewer);
  if (!content) return fail(content.error());
  if (stored) (*content)->apply(*stored);
  (*window)->connect_clipboard();
  previewer.scene().open(options.source);
  Loop(**window, previewer, **content, woken).run();

  // Waiting for a load that still runs is nothing to look at.
  (*window)->hide();
  return 0;
}

}  // namespace asos
