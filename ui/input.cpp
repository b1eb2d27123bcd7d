#include "ui/input.h"

#include <imgui.h>

#include <algorithm>
#include <bitset>

namespace asos::ui {

namespace {

// The input that a frame has taken so far. Decides whether the next event may join the frame.
struct FrameState {
  bool moved = false;
  bool wheel = false;
  bool typed = false;
  unsigned buttons = 0;                                    // changed in this frame
  std::bitset<static_cast<std::size_t>(Key::count)> keys;  // keys changed in this frame
  bool plain_key = false;                                  // at least one of them is not a modifier
  bool editing_key = false;                                // one of them edits text
};

bool is_modifier(Key key) {
  return key == Key::ctrl || key == Key::shift || key == Key::alt || key == Key::super;
}

bool edits_text(Key key) {
  return key >= Key::tab && key <= Key::escape;
}

void release_all(ImGuiIO& io) {
  std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  io.KeyCtrl = io.KeyShift = io.KeyAlt = io.KeySuper = false;
}

// Applies one event; returns false if it has to wait for the next frame.
struct Apply {
  ImGuiIO& io;
  FrameState& state;

  bool operator()(const MouseMoved& e) const {
    if (state.buttons || state.wheel) return false;
    io.MousePos = {e.position.x, e.position.y};
    state.moved = true;
    return true;
  }
  bool operator()(const MouseChanged& e) const {
    const unsigned bit = 1u << static_cast<unsigned>(e.button);
    // Moving and pressing in one frame would press the widget that was hovered before. Moving and
    // releasing would lose the last stretch of a drag.
    if ((state.buttons & bit) || state.moved) return false;
    io.MouseDown[static_cast<int>(e.button)] = e.down;
    state.buttons |= bit;
    return true;
  }
  bool operator()(const WheelTurned& e) const {
    if (state.moved || state.buttons) return false;
    io.MouseWheelH += e.steps.x;
    io.MouseWheel += e.steps.y;
    state.wheel = true;
    return true;
  }
  bool operator()(const KeyChanged& e) const {
    if (e.key == Key::none) return true;
    // Input from before a modifier changed must not see the change. Dear ImGui also processes a
    // frame's text before its keys.
    const bool acted = state.wheel || state.buttons || state.typed || state.plain_key;
    if (is_modifier(e.key) && acted) return false;
    if (state.keys[static_cast<std::size_t>(e.key)]) return false;
    if (state.typed && e.down && edits_text(e.key)) return false;
    io.KeysDown[static_cast<int>(e.key)] = e.down;
    if (e.key == Key::ctrl) io.KeyCtrl = e.down;
    if (e.key == Key::shift) io.KeyShift = e.down;
    if (e.key == Key::alt) io.KeyAlt = e.down;
    if (e.key == Key::super) io.KeySuper = e.down;
    state.keys.set(static_cast<std::size_t>(e.key));
    state.plain_key |= !is_modifier(e.key);
    state.editing_key |= edits_text(e.key);
    return true;
  }
  bool operator()(const TextTyped& e) const {
    if (state.editing_key) return false;
    io.AddInputCharacter(static_cast<unsigned>(e.character));
    state.typed = true;
    return true;
  }
  bool operator()(const FocusLost&) const {
    if (state.buttons || state.keys.any()) return false;
    release_all(io);
    return true;
  }
};

}  // namespace

void InputQueue::feed(ImGuiIO& io) {
  FrameState state;
  while (!events_.empty() && std::visit(Apply{io, state}, events_.front())) events_.pop_front();
  // Enter also acts as Space: Dear ImGui reacts to Enter on sliders by starting text input.
  const bool enter =
      io.KeysDown[static_cast<int>(Key::enter)] || io.KeysDown[static_cast<int>(Key::keypad_enter)];
  if (enter && io.NavVisible && !io.WantTextInput) io.NavInputs[ImGuiNavInput_Activate] = 1.0f;
}

void InputQueue::map_keys(ImGuiIO& io) {
  const auto map = [&io](ImGuiKey theirs, Key ours) { io.KeyMap[theirs] = static_cast<int>(ours); };
  map(ImGuiKey_Tab, Key::tab);
  map(ImGuiKey_LeftArrow, Key::left);
  map(ImGuiKey_RightArrow, Key::right);
  map(ImGuiKey_UpArrow, Key::up);
  map(ImGuiKey_DownArrow, Key::down);
  map(ImGuiKey_PageUp, Key::page_up);
  map(ImGuiKey_PageDown, Key::page_down);
  map(ImGuiKey_Home, Key::home);
  map(ImGuiKey_End, Key::end);
  map(ImGuiKey_Insert, Key::insert);
  map(ImGuiKey_Delete, Key::erase);
  map(ImGuiKey_Backspace, Key::backspace);
  map(ImGuiKey_Space, Key::space);
  map(ImGuiKey_Enter, Key::enter);
  map(ImGuiKey_KeyPadEnter, Key::keypad_enter);
  map(ImGuiKey_Escape, Key::escape);
  map(ImGuiKey_A, Key::a);
  map(ImGuiKey_C, Key::c);
  map(ImGuiKey_V, Key::v);
  map(ImGuiKey_X, Key::x);
  map(ImGuiKey_Y, Key::y);
  map(ImGuiKey_Z, Key::z);
}

bool shortcut_pressed(Key key, bool with_ctrl) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl != with_ctrl || io.KeyAlt || (io.WantTextInput && !with_ctrl)) return false;
  return ImGui::IsKeyPressed(static_cast<int>(key), false);
}

}  // namespace asos::ui
