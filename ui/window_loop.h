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

/// Decides when a window is drawn and when it sleeps: nothing is drawn while nothing changes, and
/// between two frames it always hears what has happened. Main thread only.
class WindowLoop {
 public:
  struct Hooks {
    std::atomic<bool>& woken;             ///< set by other threads: something waits for a frame
    std::function<double()> now_seconds;  ///< never falls
  };
  /// All of them must outlive it.
  WindowLoop(HostWindow& window, Previewer& previewer, WindowContent& content, Hooks hooks);

  /// Returns once the user has quit; what the window remembers is saved then, and whenever another
  /// scene is there.
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
