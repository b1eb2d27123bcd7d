#pragma once

#include "ui/input.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A window of the system as the loop that draws into it knows it; an OpenGL context belongs to it.
/// Main thread only.
class HostWindow {
 public:
  virtual ~HostWindow() = default;

  /// Hears what has happened; sleeps until something happens, or for so long (seconds).
  virtual void wait(std::optional<double> seconds) = 0;
  /// Shows what was drawn.
  virtual void present() = 0;
  virtual void set_title(const std::string& title) = 0;

  [[nodiscard]] virtual bool visible() const = 0;  ///< neither minimised nor without area
  [[nodiscard]] virtual glm::ivec2 size() const = 0;
  /// The size to ask for to get this window again; 0 where it fills the screen.
  [[nodiscard]] virtual glm::ivec2 plain_size() const = 0;
  [[nodiscard]] virtual glm::ivec2 framebuffer_size() const = 0;
  [[nodiscard]] virtual float content_scale() const = 0;

  /// The events since the last call.
  struct Happened {
    std::vector<InputEvent> input;
    std::vector<std::string> dropped_files;
    bool needs_redraw = false;    ///< uncovered, resized, moved to another screen
    bool asked_to_close = false;  ///< by the window's own button; it stays open
  };
  [[nodiscard]] virtual Happened take_happened() = 0;
};

}  // namespace asos::ui
