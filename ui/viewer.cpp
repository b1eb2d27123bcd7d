#include "ui/viewer.h"

#include "ui/previewer.h"
#include "ui/screenshot.h"
#include "ui/stored_settings.h"
#include "ui/theme.h"
#include "ui/window.h"
#include "ui/window_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace asos {

namespace {

// The user's input is followed at once; tiles that arrive are shown less often, because showing
// them takes time from rendering them.
constexpr double input_frame_seconds = 1.0 / 60.0;
constexpr double tiles_frame_seconds = 1.0 / 20.0;
constexpr double never = std::numeric_limits<double>::infinity();

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
        saved_(content.stored_settings()) {}

  void run() {
    while (!window_.should_close() && !content_.state().quit) {
      // Frames may take longer than the time between them: who only drew would hear nothing.
      window_.wait(0.0);
      take_events();
      if (!window_.visible()) {
        window_.wait(std::nullopt);
        continue;
      }
      const double due = next_frame_seconds(), now = now_seconds();
      if (now >= due) {
        draw(now);
      } else {
        window_.wait(due == never ? std::nullopt : std::optional(due - now));
      }
    }
    save();
  }

 private:
  void take_events() {
    Window::Happened happened = window_.take_happened();
    interaction_ |= !happened.input.empty() || happened.needs_redraw;
    for (const InputEvent& event : happened.input) content_.input().add(event);
    if (!happened.dropped_files.empty()) {
      previewer_.scene().open(happened.dropped_files.front());
      interaction_ = true;
    }
  }

  [[nodiscard]] double next_frame_seconds() const {
    double due = never;
    if (woken_) {
      due = last_seconds_ + (previewer_.render().first_picture_pending() ? input_frame_seconds
                                                                         : tiles_frame_seconds);
    }
    if (interaction_) due = std::min(due, last_seconds_ + input_frame_seconds);
    if (settling_) due = std::min(due, last_seconds_ + tiles_frame_seconds);
    if (const std::optional<double> wish = content_.seconds_to_redraw()) {
      due = std::min(due, last_seconds_ + std::max(*wish, input_frame_seconds));
    }
    return due;
  }

  void draw(double now) {
    last_seconds_ = now;
    // What an event shows may need a second frame to find its size.
    settling_ = interaction_ || woken_;
    interaction_ = false;
    woken_ = false;
    content_.draw({window_.size(), window_.framebuffer_size(), window_.content_scale(), now});
    window_.present();
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
    if (now == saved_) return;
    if (save_settings(settings_path(), now)) saved_ = std::move(now);
  }

  Window& window_;
  Previewer& previewer_;
  WindowContent& content_;
  std::atomic<bool>& woken_;
  StoredSettings saved_;
  std::string titled_;
  double last_seconds_ = -1.0;
  bool interaction_ = true;
  bool settling_ = false;
};

}  // namespace

int run_viewer(const ViewerOptions& options) {
  const auto fail = [](const Error& error) {
    std::fputs(fmt::format("asos: cannot open a window: {}\n", error.message()).c_str(), stderr);
    return 1;
  };
  const Result<std::unique_ptr<Window>> window =
      Window::open("ASOS", window_size_for(options.settings));
  if (!window) return fail(window.error());

  std::atomic<bool> woken = false;
  const auto wake = [&woken] {
    woken = true;
    Window::wake();
  };
  Previewer previewer({{}, wake, options.forced}, options.settings);
  const Result<std::unique_ptr<WindowContent>> content = WindowContent::make(previewer);
  if (!content) return fail(content.error());
  if (const Result<StoredSettings> stored = load_settings(settings_path()))
    (*content)->apply(*stored);
  (*window)->connect_clipboard();
  previewer.scene().open(options.source);
  Loop(**window, previewer, **content, woken).run();

  // Waiting for a load that still runs is nothing to look at.
  (*window)->hide();
  return 0;
}

}  // namespace asos
