#include "renderer/pyray/level_tally.h"

namespace asos {

void LevelTally::start(int at_level) {
  level = at_level;
  marginal = 0;
  objects.clear();
}

void LevelTally::add_cell(std::span<const std::uint32_t> objects_near, std::uint32_t hit,
                          bool one_edge) {
  ++marginal;
  for (const std::uint32_t object : objects_near) {
    auto at = std::lower_bound(
        objects.begin(), objects.end(), object,
        [](const ObjectTally& tally, std::uint32_t number) { return tally.object < number; });
    if (at == objects.end() || at->object != object) {
      at = objects.insert(at, ObjectTally{});
      at->object = object;
    }
    ++(object == hit ? at->in : at->out);
    at->one_edge &= one_edge;
  }
}

double LevelTally::largest_change() const {
  double largest = 0.0;
  for (const ObjectTally& tally : objects) largest = std::max(largest, tally.change(level));
  return largest;
}

}  // namespace asos
