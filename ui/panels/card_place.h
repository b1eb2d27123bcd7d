#pragma once

#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <span>

namespace asos::ui {

/// Where a card stands, and how wide it is. In window coordinates.
struct CardPlace {
  glm::vec2 lo{0.0f};
  float width = 0.0f;
};

/// Finds a place in `room` that touches nothing that is `taken`: in a corner, lower ones first, or
/// beside one of these. A narrower card is tried where a wide one has no place; where none has, it
/// stands where it hides least. `size`: of the card as it was drawn last, 0 where it was not. `em`:
/// the height of text.
[[nodiscard]] CardPlace card_place(const WindowRect& room, glm::vec2 size,
                                   std::span<const WindowRect> taken, float em);

}  // namespace asos::ui
