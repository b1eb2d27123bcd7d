#pragma once

#include "ui/draw_schedule.h"
#include "ui/host_window.h"
#include "ui/previewer.h"
#include "ui/stored_settings.h"
#include "ui/window_content.h"

#include <atomic>
#include <functional>
#include <string>

namespace asos::ui {

/// Decides when the window is drawn and when it sleeps. Nothing is drawn while nothing changes.
/// Events are processed between any two frames. Main thread only.
class WindowLoop {
 public:
  struct Hooks {
    std::atomic<bool>& woken;             ///< set by other threads: a frame is to be drawn
    std::function<double()> now_seconds;  ///< never falls
  };
  /// All arguments must outlive the object.
  WindowLoop(HostWindow& window, Previewer& previewer, WindowContent& content, Hooks hooks);

  /// Returns once the user has quit. Settings are saved then and whenever another scene is opened.
  void run();

 private:
  void take_events();
  void draw(double now);
  void save();

  HostWindow& window_;
  Previewer& previewer_;
  WindowContent& content_;
  Hooks hooks_;
  StoredSettings saved_;
  std::string titled_;
  DrawSchedule schedule_;
};

}  // namespace asos::ui
