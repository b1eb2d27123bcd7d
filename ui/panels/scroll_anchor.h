#pragma once

#include "ui/panels/controls.h"

#include <glm/glm.hpp>

#include <string>

namespace asos::ui {

/// Keeps the control under the pointer in place while rows above it come and go, by scrolling its
/// window. At the ends of the scroll range the control moves after all.
class ScrollAnchor {
 public:
  /// Call in the ImGui window, after its last item. Rows of inner lists are not held.
  void hold(const Controls& controls);
  /// Whether the window has to be drawn again, scrolled.
  [[nodiscard]] bool moved() const { return moved_; }

 private:
  void take(const Controls& controls, glm::vec2 pointer);

  std::string name_;  // name of the control that is held; empty: none
  float y_ = 0.0f;    // of its upper edge
  float scroll_ = 0.0f;
  glm::vec2 pointer_{0.0f};
  bool moved_ = false;
  bool started_ = false;
};

}  // namespace asos::ui
