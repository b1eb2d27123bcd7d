#include "ui/viewer.h"

#include "renderer/comparison/method.h"
#include "ui/previewer.h"
#include "ui/stored_settings.h"
#include "ui/theme.h"
#include "ui/window.h"
#include "ui/window_content.h"
#include "ui/window_loop.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace asos::ui {

namespace {

double now_seconds() {
  using Clock = std::chrono::steady_clock;
  static const Clock::time_point start = Clock::now();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

glm::ivec2 window_size_for(const RenderSettings& settings) {
  const float panel = std::round(theme::panel_width_em * theme::text_pixels);
  const float status = std::round(theme::status_height_em * theme::text_pixels);
  const float bar = std::round(theme::bar_height_em * theme::text_pixels);
  const glm::ivec2 without(settings.width + static_cast<int>(panel),
                           settings.height + static_cast<int>(status));
  const glm::ivec2 with(without.x, without.y + static_cast<int>(bar));
  const bool fits = WindowLayout::of(with, theme::text_pixels, true, true).bar.size.y > 0.0f;
  return fits ? with : without;
}

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
  const Result<std::unique_ptr<Window>> window = Window::open("ASOS", size);
  if (!window) return fail(window.error());

  std::atomic<bool> woken = false;
  const auto wake = [&woken] {
    woken = true;
    Window::wake();
  };
  Previewer previewer({{}, wake, options.forced}, settings);
  previewer.edits().keep_first(options.own_look);
  previewer.playback().options().plays_at_first = true;
  const Result<std::unique_ptr<WindowContent>> content = WindowContent::make(previewer);
  if (!content) return fail(content.error());
  if (stored) (*content)->apply(*stored);
  if (stored && !stored->tour_seen) (*content)->state().tour_asked = true;
  (*window)->connect_clipboard();
  previewer.scene().open(options.source);
  WindowLoop(**window, previewer, **content, {woken, now_seconds}).run();

  // Hides the window while a running load is awaited.
  (*window)->hide();
  return 0;
}

}  // namespace asos::ui
