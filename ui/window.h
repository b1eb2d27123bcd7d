#pragma once

#include "renderer/result.h"
#include "ui/input.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace asos {

/// A window with an OpenGL 3.3 core context, current on the calling thread; collects what the user
/// does. Main thread only, but for `wake`.
class Window {
 public:
  /// A window of about this size, smaller where the screen is. The error holds the system's reason.
  [[nodiscard]] static Result<std::unique_ptr<Window>> open(const std::string& title,
                                                            glm::ivec2 size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Sleeps until something happens, or for so long.
  void wait(std::optional<double> seconds);
  /// Ends a `wait`; from any thread.
  static void wake();
  void present();
  /// Lets Dear ImGui's current context use the system's clipboard.
  void connect_clipboard();
  void set_title(const std::string& title);
  void hide();

  [[nodiscard]] bool visible() const;  ///< neither minimised nor without area
  [[nodiscard]] glm::ivec2 size() const;
  /// The size to ask `open` for to get this window again; 0 where it fills the screen.
  [[nodiscard]] glm::ivec2 plain_size() const;
  [[nodiscard]] glm::ivec2 framebuffer_size() const;
  [[nodiscard]] float content_scale() const;

  /// The events since the last call.
  struct Happened {
    std::vector<InputEvent> input;
    std::vector<std::string> dropped_files;
    bool needs_redraw = false;    ///< uncovered, resized, moved to another screen
    bool asked_to_close = false;  ///< by the window's own button; it stays open
  };
  [[nodiscard]] Happened take_happened() { return std::exchange(happened_, {}); }

 private:
  explicit Window(GLFWwindow* window);
  void install_callbacks();

  GLFWwindow* window_;
  Happened happened_;
};

}  // namespace asos
