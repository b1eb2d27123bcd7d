#pragma once

#include "ui/panels/controls.h"

#include <glm/glm.hpp>

#include <string>

namespace asos::ui {

/// Keeps what lies under the pointer there while rows above it come and go, by scrolling the window
/// that they are in: who aims at a button hits it. At the ends of what can be scrolled they move.
class ScrollAnchor {
 public:
  /// In the ImGui window in question, after its last item. Rows of lists inside it hold nothing.
  void hold(const Controls& controls);
  /// Whether the window is to be drawn again, scrolled.
  [[nodiscard]] bool moved() const { return moved_; }

 private:
  void take(const Controls& controls, glm::vec2 pointer);

  std::string name_;  // of the control that is held; empty: none
  float y_ = 0.0f;    // of its upper edge
  float scroll_ = 0.0f;
  glm::vec2 pointer_{0.0f};
  bool moved_ = false;
};

}  // namespace asos::ui
