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

/// A window with an OpenGL 3.3 core context, current on the calling thread; collects what the user
/// does. Main thread only, but for `wake`.
class Window final : public HostWindow {
 public:
  /// A window of about this size, smaller where the screen is. The error holds the system's reason.
  [[nodiscard]] static Result<std::unique_ptr<Window>> open(const std::string& title,
                                                            glm::ivec2 size);
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void wait(std::optional<double> seconds) override;
  /// Ends a `wait`; from any thread.
  static void wake();
  void present() override;
  /// Lets Dear ImGui's current context use the system's clipboard.
  void connect_clipboard();
  void set_title(const std::string& title) override;
  void hide();

  [[nodiscard]] bool visible() const override;
  [[nodiscard]] glm::ivec2 size() const override;
  [[nodiscard]] glm::ivec2 plain_size() const override;
  [[nodiscard]] glm::ivec2 framebuffer_size() const override;
  [[nodiscard]] float content_scale() const override;
  [[nodiscard]] Happened take_happened() override { return std::exchange(happened_, {}); }

 private:
  explicit Window(GLFWwindow* window);
  void install_callbacks();

  GLFWwindow* window_;
  Happened happened_;
};

}  // namespace asos::ui
