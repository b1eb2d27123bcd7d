#include "renderer/session/work_plan.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace asos {

static_assert(group_size % block_size == 0);

namespace {

/// The aligned squares of `side` that touch `area`, clipped to `picture`, row by row.
std::vector<PixelRect> squares(PixelRect area, int side, PixelRect picture) {
  std::vector<PixelRect> rects;
  for (int y = area.y / side * side; y < area.y + area.height; y += side) {
    for (int x = area.x / side * side; x < area.x + area.width; x += side) {
      rects.push_back(intersection({x, y, side, side}, picture));
    }
  }
  return rects;
}

// Returns the position along a Hilbert curve through a square of `side` x `side`, a power of two.
std::uint64_t along_hilbert_curve(std::uint64_t side, std::uint64_t x, std::uint64_t y) {
  std::uint64_t along = 0;
  for (std::uint64_t half = side / 2; half > 0; half /= 2) {
    const bool right = x & half, lower = y & half;
    along += half * half * (right ? (lower ? 2u : 3u) : (lower ? 1u : 0u));
    if (lower) continue;
    if (right) x = side - 1 - x, y = side - 1 - y;
    std::swap(x, y);
  }
  return along;
}

// Orders pieces along a Hilbert curve: its neighbours are neighbours in the picture, unlike those
// on a ring of the plan.
template <typename Pieces>
std::vector<std::size_t> spread_over(const Pieces& pieces, int side) {
  constexpr std::uint64_t squares = 1u << 13;  // 8-pixel squares per side: more than any picture
  std::vector<std::pair<std::uint64_t, std::size_t>> curve;
  curve.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PixelRect& rect = pieces[i].rect;
    curve.emplace_back(along_hilbert_curve(squares, static_cast<std::uint64_t>(rect.x / side),
                                           static_cast<std::uint64_t>(rect.y / side)),
                       i);
  }
  std::sort(curve.begin(), curve.end());
  std::vector<std::size_t> order = spread_order(pieces.size());
  for (std::size_t& piece : order) piece = curve[piece].second;
  return order;
}

}  // namespace

std::vector<std::size_t> spread_order(std::size_t count) {
  constexpr double golden_section = 0.61803398874989485;
  std::vector<double> at(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = golden_section * static_cast<double>(i);
    at[i] = turns - std::floor(turns);
  }
  // The order of the multiples of the golden section: each place's rank among all of them.
  std::vector<std::size_t> by_place(count);
  std::iota(by_place.begin(), by_place.end(), std::size_t{0});
  std::sort(by_place.begin(), by_place.end(), [&](std::size_t x, std::size_t y) {
    return std::tuple(at[x], x) < std::tuple(at[y], y);
  });
  std::vector<std::size_t> order(count);
  for (std::size_t rank = 0; rank < count; ++rank) order[by_place[rank]] = rank;
  return order;
}

WorkPlan::WorkPlan(const RenderSettings& settings) : visible(settings.visible()) {
  const PixelRect picture{0, 0, settings.width, settings.height};
  const int side = block_side(settings);
  std::vector<PixelRect> rects = squares(visible, group_size, picture);

  // Twice the squared distance from the centre, in integers.
  const auto distance = [&](const PixelRect& r) {
    const std::int64_t dx = 2 * r.x + r.width - (2 * visible.x + visible.width);
    const std::int64_t dy = 2 * r.y + r.height - (2 * visible.y + visible.height);
    return dx * dx + dy * dy;
  };
  std::sort(rects.begin(), rects.end(), [&](const PixelRect& a, const PixelRect& b) {
    return std::tuple(distance(a), a.y, a.x) < std::tuple(distance(b), b.y, b.x);
  });

  for (const PixelRect& rect : rects) {
    BlockGroup group{rect, blocks.size(), 0};
    for (const PixelRect& block : squares(intersection(rect, visible), side, picture)) {
      blocks.push_back({block, groups.size()});
    }
    group.block_count = blocks.size() - group.first_block;
    groups.push_back(group);
  }
}

std::vector<std::size_t> WorkPlan::spread_blocks() const {
  return spread_over(blocks, block_size);
}

std::vector<std::size_t> WorkPlan::spread_groups() const {
  return spread_over(groups, group_size);
}

}  // namespace asos
