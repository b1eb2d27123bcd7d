#include "ui/window.h"

#include "ui/gl/gl.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace asos::ui {

namespace {

std::string& last_glfw_error() {
  static std::string text;
  return text;
}

Window* owner(GLFWwindow* window) {
  return static_cast<Window*>(glfwGetWindowUserPointer(window));
}

constexpr std::pair<int, Key> named_keys[] = {
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_INSERT, Key::insert},
    {GLFW_KEY_DELETE, Key::erase},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::keypad_enter},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_LEFT_CONTROL, Key::ctrl},
    {GLFW_KEY_RIGHT_CONTROL, Key::ctrl},
    {GLFW_KEY_LEFT_SHIFT, Key::shift},
    {GLFW_KEY_RIGHT_SHIFT, Key::shift},
    {GLFW_KEY_LEFT_ALT, Key::alt},
    {GLFW_KEY_RIGHT_ALT, Key::alt},
    {GLFW_KEY_LEFT_SUPER, Key::super},
    {GLFW_KEY_RIGHT_SUPER, Key::super},
    {GLFW_KEY_F1, Key::f1},
    {GLFW_KEY_F6, Key::f6},
    {GLFW_KEY_F12, Key::f12},
    {GLFW_KEY_KP_ADD, Key::plus},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_KP_0, Key::zero},
    {GLFW_KEY_KP_1, Key::pad_one},
    {GLFW_KEY_KP_3, Key::pad_three},
    {GLFW_KEY_KP_5, Key::pad_five},
    {GLFW_KEY_KP_7, Key::pad_seven},
};

// The characters on the keys from Key::question on, in Key's order.
constexpr std::string_view printed_keys = "?+-0123456789abcdefghiklmnopqrstuvwxyz[]";
static_assert(static_cast<std::size_t>(Key::question) + printed_keys.size() ==
              static_cast<std::size_t>(Key::count));

// Letters follow the user's keyboard layout, not the key's position.
Key key_of(int key, int scancode, int modifiers) {
  for (const auto& [code, name] : named_keys) {
    if (code == key) return name;
  }
  const char* printed = glfwGetKeyName(key, scancode);
  if (!printed) return Key::none;
  const std::string_view text = printed;
  if (text == "/" && (modifiers & GLFW_MOD_SHIFT)) return Key::question;
  if (text == "=") return Key::plus;
  const std::size_t at = text.size() == 1 ? printed_keys.find(text) : std::string_view::npos;
  return at == std::string_view::npos
             ? Key::none
             : static_cast<Key>(static_cast<std::size_t>(Key::question) + at);
}

gl::Function get_function(const char* name) {
  return glfwGetProcAddress(name);
}

// Shrinks the window to the screen's work area. Called after the window is created: only then are
// its scale and the size of its frame known.
void fit_on_screen(GLFWwindow* window) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return;
  glm::ivec2 corner(0), room(0), size(0), at(0), before(0), after(0);
  glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &room.x, &room.y);
  glfwGetWindowFrameSize(window, &before.x, &before.y, &after.x, &after.y);
  glfwGetWindowSize(window, &size.x, &size.y);
  const glm::ivec2 most = room - before - after;
  if (most.x <= 0 || most.y <= 0 || (size.x <= most.x && size.y <= most.y)) return;
  size = glm::min(size, most);
  glfwSetWindowSize(window, size.x, size.y);
  glfwGetWindowPos(window, &at.x, &at.y);
  at = glm::max(glm::min(at, corner + room - after - size), corner + before);
  glfwSetWindowPos(window, at.x, at.y);
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, glm::ivec2 size) {
  glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text ? text : ""; });
  if (!glfwInit()) return unexpected(Error{"window", last_glfw_error()});
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "asos");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "asos");

  GLFWwindow* handle = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!handle) {
    const Error error{"window", last_glfw_error()};
    glfwTerminate();
    return unexpected(error);
  }
  std::unique_ptr<Window> window(new Window(handle));
  fit_on_screen(handle);
  glfwMakeContextCurrent(handle);
  glfwSwapInterval(1);
  if (const Result<void> loaded = gl::load(get_function); !loaded) {
    return unexpected(loaded.error());
  }
  return window;
}

Window::Window(GLFWwindow* window) : window_(window) {
  install_callbacks();
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::install_callbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    owner(w)->happened_.input.push_back(MouseMoved{{static_cast<float>(x), static_cast<float>(y)}});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    // Outside the window nothing is hovered. During a drag positions are still reported.
    if (!entered) owner(w)->happened_.input.push_back(MouseMoved{{-1e5f, -1e5f}});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    if (button < 0 || button > 2) return;
    owner(w)->happened_.input.push_back(
        MouseChanged{static_cast<MouseButton>(button), action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    owner(w)->happened_.input.push_back(
        WheelTurned{{static_cast<float>(x), static_cast<float>(y)}});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    if (action == GLFW_REPEAT) return;  // Dear ImGui repeats keys itself.
    owner(w)->happened_.input.push_back(
        KeyChanged{key_of(key, scancode, modifiers), action == GLFW_PRESS});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) {
    owner(w)->happened_.input.push_back(TextTyped{static_cast<char32_t>(character)});
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    if (!focused) owner(w)->happened_.input.push_back(FocusLost{});
    owner(w)->happened_.needs_redraw = true;
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    owner(w)->happened_.dropped_files.insert(owner(w)->happened_.dropped_files.end(), paths,
                                             paths + count);
  });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    owner(w)->happened_.asked_to_close = true;
  });
  glfwSetWindowRefreshCallback(window_,
                               [](GLFWwindow* w) { owner(w)->happened_.needs_redraw = true; });
  glfwSetFramebufferSizeCallback(
      window_, [](GLFWwindow* w, int, int) { owner(w)->happened_.needs_redraw = true; });
  glfwSetWindowIconifyCallback(window_,
                               [](GLFWwindow* w, int) { owner(w)->happened_.needs_redraw = true; });
  glfwSetWindowContentScaleCallback(
      window_, [](GLFWwindow* w, float, float) { owner(w)->happened_.needs_redraw = true; });
}

void Window::wait(std::optional<double> seconds) {
  if (!seconds) {
    glfwWaitEvents();
  } else if (*seconds > 0.0) {
    glfwWaitEventsTimeout(*seconds);
  } else {
    glfwPollEvents();
  }
}

void Window::wake() {
  glfwPostEmptyEvent();
}

void Window::present() {
  glfwSwapBuffers(window_);
}

void Window::connect_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = window_;
  io.SetClipboardTextFn = [](void* window, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
  };
  io.GetClipboardTextFn = [](void* window) {
    return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
  };
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::hide() {
  glfwHideWindow(window_);
  glfwPollEvents();
}

bool Window::visible() const {
  const glm::ivec2 pixels = framebuffer_size();
  return !glfwGetWindowAttrib(window_, GLFW_ICONIFIED) && pixels.x > 0 && pixels.y > 0;
}

glm::ivec2 Window::size() const {
  glm::ivec2 size(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 Window::plain_size() const {
  if (glfwGetWindowAttrib(window_, GLFW_MAXIMIZED)) return glm::ivec2(0);
  const glm::vec2 window(size()), framebuffer(framebuffer_size());
  if (window.y <= 0.0f || framebuffer.y <= 0.0f) return glm::ivec2(0);
  // On systems that measure windows in pixels, scale a new window by the screen's scale.
  const float scale = content_scale() * window.y / framebuffer.y;
  return glm::ivec2(glm::round(window / (scale > 0.0f ? scale : 1.0f)));
}

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float Window::content_scale() const {
  float x = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max(x, y);
}

}  // namespace asos::ui
