#pragma once

#include <glm/glm.hpp>

namespace asos::ui {

/// A list with a height of its own within a panel, while it lives. The wheel scrolls the panel
/// until the list is clicked, so that lists do not catch it on the way.
class InnerList {
 public:
  InnerList(const char* name, glm::vec2 size);
  ~InnerList();
  InnerList(const InnerList&) = delete;
  InnerList& operator=(const InnerList&) = delete;
};

}  // namespace asos::ui
