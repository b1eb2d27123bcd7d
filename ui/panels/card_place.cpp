#include "ui/panels/card_place.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace asos::ui {

namespace {

constexpr float widths_em[] = {25.0f, 21.0f, 17.0f, 14.5f};

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

}  // namespace

CardPlace card_place(const WindowRect& room, glm::vec2 size, std::span<const WindowRect> taken,
                     float em) {
  const float gap = 0.3f * em;
  const glm::vec2 drawn = size.x > 0.0f ? size : em * glm::vec2(widths_em[0], 14.0f);
  CardPlace best;
  float least = std::numeric_limits<float>::infinity();
  for (const float width_em : widths_em) {
    const float width = std::min(width_em * em, room.size.x);
    // A narrower card needs more lines. Overestimates: titles and buttons keep their height.
    const float height = std::min(drawn.y * std::max(1.0f, drawn.x / width), room.size.y);
    for (const float y : starts(room, height, taken, 1, gap)) {
      for (const float x : starts(room, width, taken, 0, gap)) {
        float hidden = 0.0f;
        for (const WindowRect& rect : taken)
          hidden += covered_fraction(rect, {{x, y}, {width, height}});
        if (hidden >= least) continue;
        least = hidden;
        best = {{x, y}, width};
      }
    }
    if (least <= 0.0f) break;
  }
  return best;
}

}  // namespace asos::ui
