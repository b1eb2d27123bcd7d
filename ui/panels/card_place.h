#pragma once

#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace asos::ui {

/// Number of widths that a card can have.
inline constexpr std::size_t card_widths = 4;
/// Heights of a card by its widths, from the widest, in window coordinates; 0: not drawn yet.
using CardHeights = std::array<float, card_widths>;

/// Place of a card, in window coordinates.
struct CardPlace {
  glm::vec2 lo{0.0f};
  float width = 0.0f;
  float height = 0.0f;    ///< estimated if the card was not drawn with this width yet
  std::size_t index = 0;  ///< of the width
  bool too_high = false;  ///< the drawn card is higher than the room
  bool free = false;      ///< covers nothing that is taken
};

/// The part of the picture in which cards are placed. `em`: the height of text.
[[nodiscard]] WindowRect room_for_card(const WindowRect& picture, float em);

/// Finds a place in `room` that overlaps nothing in `taken`: corners first, lower ones before upper
/// ones, then places next to taken rectangles. Tries narrower cards if a wide one has no place. If
/// none fits, covers the smallest fractions of the taken rectangles. `em`: the height of text.
///
/// The result depends only on heights that were drawn, so that a card rests once every width in
/// question was drawn. A height that is only estimated may turn out wrong.
[[nodiscard]] CardPlace card_place(const WindowRect& room, const CardHeights& heights,
                                   std::span<const WindowRect> taken, float em);
/// Lists the places that card_place tries and that overlap nothing in `taken`.
[[nodiscard]] std::vector<CardPlace> free_card_places(const WindowRect& room,
                                                      const CardHeights& heights,
                                                      std::span<const WindowRect> taken, float em);

}  // namespace asos::ui
