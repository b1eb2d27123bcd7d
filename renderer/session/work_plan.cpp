#include "renderer/session/work_plan.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <tuple>

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

}  // namespace

WorkPlan::WorkPlan(const RenderSettings& settings) : visible(settings.visible()) {
  const PixelRect picture{0, 0, settings.width, settings.height};
  const int side = block_side(settings);
  std::vector<PixelRect> rects = squares(visible, group_size, picture);

  // Twice the squared distance from the middle, in integers.
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

}  // namespace asos
