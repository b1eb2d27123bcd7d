#include "ui/panels/card_place.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace asos::ui {

namespace {

constexpr std::array<float, card_widths> widths_em{25.0f, 21.0f, 17.0f, 14.5f};
constexpr float usual_height_em = 14.0f;

// Returns the covered fraction of a rectangle: to cover a pixel is as bad as to cover a whole
// panel.
float covered_fraction(const WindowRect& rect, const WindowRect& by) {
  const glm::vec2 lo = glm::max(rect.lo, by.lo);
  const glm::vec2 hi = glm::min(rect.lo + rect.size, by.lo + by.size);
  if (hi.x <= lo.x || hi.y <= lo.y) return 0.0f;
  return (hi.x - lo.x) * (hi.y - lo.y) / (rect.size.x * rect.size.y);
}

// Lists coordinates to try: both ends of the room, then those next to taken rectangles.
std::vector<float> starts(const WindowRect& room, float size, std::span<const WindowRect> taken,
                          glm::length_t axis, float gap) {
  const float first = room.lo[axis], last = std::max(first, first + room.size[axis] - size);
  std::vector<float> all{last, first};
  for (const WindowRect& rect : taken) {
    all.push_back(std::clamp(rect.lo[axis] - gap - size, first, last));
    all.push_back(std::clamp(rect.lo[axis] + rect.size[axis] + gap, first, last));
  }
  return all;
}

// Returns the height of a card. Estimates it from the next wider card that was drawn, or else from
// the next narrower one, which is higher.
float height_of(const CardHeights& heights, std::size_t index, float em) {
  if (heights[index] > 0.0f) return heights[index];
  // A narrower card needs more lines. Overestimates: titles and buttons keep their height.
  for (std::size_t wider = index; wider-- > 0;)
    if (heights[wider] > 0.0f) return heights[wider] * widths_em[wider] / widths_em[index];
  for (std::size_t narrower = index + 1; narrower < card_widths; ++narrower)
    if (heights[narrower] > 0.0f) return heights[narrower];
  return usual_height_em * em * widths_em[0] / widths_em[index];
}

// Lists the places to try for a card of one width.
std::vector<CardPlace> places(const WindowRect& room, const CardHeights& heights, std::size_t index,
                              std::span<const WindowRect> taken, float em) {
  const float gap = 0.3f * em;
  const float width = std::min(widths_em[index] * em, room.size.x);
  const float whole = height_of(heights, index, em);
  const float height = std::min(whole, room.size.y);
  const bool too_high = heights[index] > 0.0f && whole > room.size.y;
  std::vector<CardPlace> all;
  for (const float y : starts(room, height, taken, 1, gap))
    for (const float x : starts(room, width, taken, 0, gap))
      all.push_back({{x, y}, width, height, index, too_high, false});
  return all;
}

float hidden_by(const CardPlace& place, std::span<const WindowRect> taken) {
  float hidden = 0.0f;
  for (const WindowRect& rect : taken)
    hidden += covered_fraction(rect, {place.lo, {place.width, place.height}});
  return hidden;
}

}  // namespace

WindowRect room_for_card(const WindowRect& picture, float em) {
  return {picture.lo + 0.5f * em, picture.size - em};
}

CardPlace card_place(const WindowRect& room, const CardHeights& heights,
                     std::span<const WindowRect> taken, float em) {
  CardPlace best;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t index = 0; index < card_widths && least > 0.0f; ++index) {
    for (const CardPlace& place : places(room, heights, index, taken, em)) {
      const float hidden = hidden_by(place, taken);
      if (hidden >= least) continue;
      least = hidden;
      best = place;
      best.free = hidden == 0.0f;
    }
  }
  return best;
}

std::vector<CardPlace> free_card_places(const WindowRect& room, const CardHeights& heights,
                                        std::span<const WindowRect> taken, float em) {
  std::vector<CardPlace> all;
  for (std::size_t index = 0; index < card_widths; ++index) {
    for (CardPlace& place : places(room, heights, index, taken, em)) {
      place.free = hidden_by(place, taken) == 0.0f;
      if (place.free) all.push_back(place);
    }
  }
  return all;
}

}  // namespace asos::ui
