#pragma once

#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <span>

namespace asos::ui {

/// Position and width of a card, in window coordinates.
struct CardPlace {
  glm::vec2 lo{0.0f};
  float width = 0.0f;
};

/// Finds a place in `room` that overlaps nothing in `taken`: corners first, lower ones before upper
/// ones, then places next to taken rectangles. Tries narrower cards if a wide one has no place. If
/// none fits, covers the smallest fractions of the taken rectangles. `size`: the card's size when
/// it was drawn last; 0: not drawn yet. `em`: the height of text.
[[nodiscard]] CardPlace card_place(const WindowRect& room, glm::vec2 size,
                                   std::span<const WindowRect> taken, float em);

}  // namespace asos::ui
