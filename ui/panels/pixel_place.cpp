#include "ui/panels/pixel_place.h"

#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

constexpr float pixel_width_em = 24.0f;
constexpr float least_width_em = 17.0f;   // of a panel next to a pixel near the centre
constexpr float least_height_em = 14.0f;  // of a panel below the picture

// Lists the bounds of free rectangles along an axis: the ends of the room and the taken rectangles.
std::vector<float> bounds(const WindowRect& room, std::span<const WindowRect> taken,
                          glm::length_t axis, float gap) {
  const float first = room.lo[axis], last = first + room.size[axis];
  std::vector<float> all{first, last};
  for (const WindowRect& rect : taken) {
    all.push_back(std::clamp(rect.lo[axis] - gap, first, last));
    all.push_back(std::clamp(rect.lo[axis] + rect.size[axis] + gap, first, last));
  }
  return all;
}

bool overlap(glm::vec2 lo, glm::vec2 hi, const WindowRect& rect) {
  const glm::vec2 end = rect.lo + rect.size;
  return lo.x < end.x && rect.lo.x < hi.x && lo.y < end.y && rect.lo.y < hi.y;
}

// Ranks sizes of a panel. Its drawing is a square: the shorter side counts, then the longer one.
std::pair<float, float> rank_of(glm::vec2 size) {
  return {std::min(size.x, size.y), std::max(size.x, size.y)};
}

// Returns the largest rectangle of `room` that overlaps nothing in `taken`. `usual`: size limit, as
// a larger panel is of no use.
WindowRect largest_free(const WindowRect& room, std::span<const WindowRect> taken, float gap,
                        glm::vec2 usual) {
  WindowRect best{room.lo, glm::vec2(0.0f)};
  std::pair<float, float> most{0.0f, 0.0f};
  const std::vector<float> xs = bounds(room, taken, 0, gap), ys = bounds(room, taken, 1, gap);
  const auto consider = [&](glm::vec2 lo, glm::vec2 hi) {
    const glm::vec2 counted = glm::min(hi - lo, usual);
    if (rank_of(counted) <= most) return;
    for (const WindowRect& rect : taken)
      if (overlap(lo, hi, rect)) return;
    most = rank_of(counted);
    best = {lo, glm::vec2(counted.x, hi.y - lo.y)};
  };
  for (const float left : xs)
    for (const float right : xs)
      for (const float top : ys)
        for (const float bottom : ys) consider({left, top}, {right, bottom});
  return best;
}

}  // namespace

PixelPlace place_beside_card(const PixelPlace& usual, const WindowRect& pixel,
                             const WindowRect& picture, const CardHeights& heights, float em) {
  if (usual.side == PixelPlace::Side::below_picture) return usual;
  const WindowRect room = room_for_card(picture, em);
  const WindowRect around{pixel.lo - em, pixel.size + 2.0f * em};
  const std::array both{WindowRect{usual.lo, {usual.width, usual.most_height}}, around};
  if (card_place(room, heights, both, em).free) return usual;
  const glm::vec2 whole(pixel_width_em * em, picture.size.y);
  PixelPlace best = usual;
  std::pair<float, float> most{0.0f, 0.0f};
  for (const CardPlace& card :
       free_card_places(room, heights, std::span<const WindowRect>(&around, 1), em)) {
    const std::array taken{around, WindowRect{card.lo, {card.width, card.height}}};
    const WindowRect at = largest_free(room, taken, 0.3f * em, whole);
    if (rank_of(at.size) <= most) continue;
    most = rank_of(at.size);
    best = {PixelPlace::Side::left, at.lo, at.size.x, at.size.y};
  }
  return best;
}

PixelPlace place_beside_pixel(glm::vec2 pixel, const WindowRect& picture, glm::vec2 window,
                              float em) {
  const float gap = 0.5f * em;
  const float clear = 1.5f * em;  // around the pixel, so that its neighbours stay visible
  const glm::vec2 lo = picture.lo + gap, hi = picture.lo + picture.size - gap;
  const float width = std::min(pixel_width_em * em, hi.x - lo.x);
  PixelPlace place{PixelPlace::Side::left, lo, width, hi.y - lo.y};
  const bool seen = pixel.x >= picture.lo.x && pixel.y >= picture.lo.y && pixel.x <= hi.x + gap &&
                    pixel.y <= hi.y + gap;
  const float left = pixel.x - clear - lo.x, right = hi.x - clear - pixel.x;
  const float below = hi.y + gap + theme::status_height_em * em;
  if (window.y - below - 2.0f * gap > least_height_em * em) {
    place.side = PixelPlace::Side::below_picture;
    place.lo.y = below + gap;
    place.most_height = window.y - below - 2.0f * gap;
    return place;
  }
  if (!seen || left > width) return place;
  if (std::max(left, right) > least_width_em * em) {
    const bool at_left = right < width && left > right;
    place.width = std::min(width, at_left ? left : right);
    if (at_left) return place;
    place.side = PixelPlace::Side::right;
    place.lo.x = hi.x - place.width;
    return place;
  }
  const bool above = pixel.y - lo.y > hi.y - pixel.y;
  place.side = above ? PixelPlace::Side::above_pixel : PixelPlace::Side::below_pixel;
  if (!above) place.lo.y = pixel.y + clear;
  place.most_height = above ? pixel.y - clear - lo.y : hi.y - place.lo.y;
  return place;
}

WindowRect shown_pixel(glm::ivec2 pixel, const PictureView& view, const PictureArea& area) {
  const float scale = view.scale() / area.scale;
  return {area.rect.lo + view.offset() / area.scale + glm::vec2(pixel) * scale, glm::vec2(scale)};
}

std::optional<PixelPlace> picked_place(const UiState& state, const PictureArea& area, float em) {
  if (!state.picked || state.view.scale() <= 0.0f) return std::nullopt;
  const WindowRect at = shown_pixel(*state.picked, state.view, area);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  PixelPlace place =
      place_beside_pixel(at.lo + 0.5f * at.size, area.rect, {window.x, window.y}, em);
  const bool over = place.side == PixelPlace::Side::left || place.side == PixelPlace::Side::right;
  if (!state.tour.card) return place;
  if (over) {
    // The tour's card takes the other half.
    constexpr float least_em = 16.0f;
    const float width =
        std::min(place.width, std::max(least_em * em, 0.5f * area.rect.size.x - em));
    if (place.side == PixelPlace::Side::right) place.lo.x += place.width - width;
    place.width = width;
  }
  return place_beside_card(place, at, area.rect, state.tour.drawn.heights, em);
}

}  // namespace asos::ui
