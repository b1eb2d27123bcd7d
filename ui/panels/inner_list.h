#pragma once

#include <glm/glm.hpp>

namespace asos::ui {

/// During its lifetime, draws a list with its own height within a panel. The wheel scrolls the
/// panel until the list is clicked, so that passing over a list does not stop the scrolling.
class InnerList {
 public:
  InnerList(const char* name, glm::vec2 size);
  ~InnerList();
  InnerList(const InnerList&) = delete;
  InnerList& operator=(const InnerList&) = delete;
};

}  // namespace asos::ui
