#pragma once

#include <glm/glm.hpp>

#include <deque>
#include <string>
#include <string_view>
#include <variant>

struct ImGuiIO;

namespace asos::ui {

/// Keys that the window uses; letters are those printed on the user's keyboard.
enum class Key : int {
  none,
  tab,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  insert,
  erase,
  backspace,
  space,
  enter,
  keypad_enter,
  escape,
  ctrl,
  shift,
  alt,
  super,
  f1,
  f6,
  f12,
  pad_one,
  pad_three,
  pad_five,
  pad_seven,
  question,
  plus,
  minus,
  zero,
  one,
  two,
  three,
  four,
  five,
  six,
  seven,
  eight,
  nine,
  a,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,
  left_bracket,
  right_bracket,
  count
};

enum class MouseButton : int { left, right, middle };

struct MouseMoved {
  glm::vec2 position;  ///< window coordinates, y down
};
struct MouseChanged {
  MouseButton button;
  bool down;
};
struct WheelTurned {
  glm::vec2 steps;  ///< y > 0: the wheel turns away from the user
};
struct KeyChanged {
  Key key;
  bool down;
};
struct TextTyped {
  char32_t character;
};
struct FocusLost {};

using InputEvent =
    std::variant<MouseMoved, MouseChanged, WheelTurned, KeyChanged, TextTyped, FocusLost>;

/// Queues events for Dear ImGui, whose state holds only one change of a button per frame. Events
/// that would hide each other wait for the next frame, so a click shorter than a frame still
/// counts. The window and the tests feed the same queue.
class InputQueue {
 public:
  void add(InputEvent event) { events_.push_back(event); }
  [[nodiscard]] bool empty() const { return events_.empty(); }

  /// Moves the events that one frame can take into `io`; call before ImGui::NewFrame.
  void feed(ImGuiIO& io);

  /// Registers our key codes with Dear ImGui; call once per context.
  static void map_keys(ImGuiIO& io);

 private:
  std::deque<InputEvent> events_;
};

/// Whether `key` went down in this frame (no repeats) while no text is being typed.
[[nodiscard]] bool shortcut_pressed(Key key, bool with_ctrl = false);

}  // namespace asos::ui
