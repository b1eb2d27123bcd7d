#pragma once

#include "ui/input.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// The window that the drawing loop needs from the system, with its OpenGL context. Main thread
/// only.
class HostWindow {
 public:
  virtual ~HostWindow() = default;

  /// Sleeps until an event comes or the time (seconds) is up, then processes events.
  virtual void wait(std::optional<double> seconds) = 0;
  /// Shows what was drawn.
  virtual void present() = 0;
  virtual void set_title(const std::string& title) = 0;

  [[nodiscard]] virtual bool visible() const = 0;  ///< neither minimised nor of zero area
  [[nodiscard]] virtual glm::ivec2 size() const = 0;
  /// The size that opens this window again; 0 if it fills the screen.
  [[nodiscard]] virtual glm::ivec2 plain_size() const = 0;
  [[nodiscard]] virtual glm::ivec2 framebuffer_size() const = 0;
  [[nodiscard]] virtual float content_scale() const = 0;

  /// The events since the last call.
  struct WindowEvents {
    std::vector<InputEvent> input;
    std::vector<std::string> dropped_files;
    bool needs_redraw = false;    ///< uncovered, resized, moved to another screen
    bool asked_to_close = false;  ///< the close button was pressed; the window stays open
  };
  [[nodiscard]] virtual WindowEvents take_happened() = 0;
};

}  // namespace asos::ui
