#pragma once

#include "renderer/result.h"
#include "ui/host_window.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>

struct GLFWwindow;

namespace asos::ui {

/// A window with an OpenGL 3.3 core context that is current on the calling thread; collects input
/// events. Main thread only, except `wake`.
class Window final : public HostWindow {
 public:
  /// Opens a window of this size or, on a smaller screen, less. The error is the system's reason.
  [[nodiscard]] static Result<std::unique_ptr<Window>> open(const std::string& title,
                                                            glm::ivec2 size);
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void wait(std::optional<double> seconds) override;
  /// Ends a `wait`. Thread-safe.
  static void wake();
  void present() override;
  /// Connects Dear ImGui's current context to the system's clipboard.
  void connect_clipboard();
  void set_title(const std::string& title) override;
  void hide();

  [[nodiscard]] bool visible() const override;
  [[nodiscard]] glm::ivec2 size() const override;
  [[nodiscard]] glm::ivec2 plain_size() const override;
  [[nodiscard]] glm::ivec2 framebuffer_size() const override;
  [[nodiscard]] float content_scale() const override;
  [[nodiscard]] WindowEvents take_happened() override { return std::exchange(happened_, {}); }

 private:
  explicit Window(GLFWwindow* window);
  void install_callbacks();

  GLFWwindow* window_;
  WindowEvents happened_;
};

}  // namespace asos::ui
