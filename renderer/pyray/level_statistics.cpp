#include "renderer/pyray/level_statistics.h"

namespace asos {

void LevelStatistics::start(int at_level) {
  level = at_level;
  marginal = 0;
  objects.clear();
}

void LevelStatistics::add_cell(std::span<const std::uint32_t> objects_near, std::uint32_t hit,
                               bool one_edge) {
  ++marginal;
  for (const std::uint32_t object : objects_near) {
    auto at = std::lower_bound(
        objects.begin(), objects.end(), object,
        [](const ObjectStatistics& tally, std::uint32_t number) { return tally.object < number; });
    if (at == objects.end() || at->object != object) {
      at = objects.insert(at, ObjectStatistics{});
      at->object = object;
    }
    ++(object == hit ? at->in : at->out);
    at->one_edge &= one_edge;
  }
}

double LevelStatistics::largest_change() const {
  double largest = 0.0;
  for (const ObjectStatistics& tally : objects) largest = std::max(largest, tally.change(level));
  return largest;
}

}  // namespace asos
