#include "renderer/session/level_choice.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <numeric>

namespace asos {

// Measured over 13 scenes at MAX 0 to 3: with these weights ratios of work are those of processor
// time but for a third either way.
double work_of(const RenderStatistics& counts) {
  constexpr double cell = 2.0;
  constexpr double shadow_pyray = 16.0;
  const auto& cells = counts.pyrays_by_level;
  const auto examined =
      static_cast<double>(std::accumulate(cells.begin(), cells.end(), std::uint64_t{0}));
  return static_cast<double>(counts.rays()) + cell * examined +
         shadow_pyray * static_cast<double>(counts.shadow_pyrays);
}

std::vector<int> possible_levels(const RenderSettings& settings) {
  if (!in_object_space(settings.method)) return {};
  std::vector<int> levels(static_cast<std::size_t>(settings.asos.max_level));
  std::iota(levels.begin(), levels.end(), 0);
  return levels;
}

double extrapolate_work(WorkByLevel& work, int max_level) {
  constexpr auto last = static_cast<std::size_t>(deepest_tried_level);
  const double growth = work[last - 1] > 0.0 ? work[last] / work[last - 1] : 1.0;
  const double less = 1.0 + 0.5 * std::max(0.0, growth - 1.0);
  for (std::size_t level = last + 1; level <= static_cast<std::size_t>(max_level); ++level)
    work[level] = work[level - 1] * less;
  return work[static_cast<std::size_t>(max_level)];
}

std::vector<int> choose_levels(const std::vector<int>& possible, const WorkByLevel& work,
                               double before, double final_work) {
  if (!(final_work > 0.0)) return {};
  double room = (most_work_of_passes - 1.0) * final_work - before;
  std::vector<int> chosen;
  for (const int level : possible) {
    const double needed = work[static_cast<std::size_t>(level)];
    if (level == 0) continue;
    if (needed > room) break;
    chosen.push_back(level);
    room -= needed;
  }
  // MAX 0 shows outlines less well than MAX 1 does for two thirds of the work.
  if (chosen.empty() && !possible.empty() && possible.front() == 0 && work[0] <= room)
    chosen.push_back(0);
  return chosen;
}

}  // namespace asos
