#pragma once

#include "renderer/film/statistics.h"
#include "renderer/settings/settings.h"

#include <array>
#include <vector>

namespace asos {

/// Work of some blocks in passes of each MAX, in units that depend on nothing but the picture:
/// rays, with what else takes time counted as so many of them.
using WorkByLevel = std::array<double, max_level_limit + 1>;
[[nodiscard]] double work_of(const RenderStatistics& counts);

/// All passes together may take this many times what the final one takes by itself.
inline constexpr double most_work_of_passes = 1.3;

/// The MAX of the passes that may come before the final one, from low to high: none of a method
/// that splits nothing.
[[nodiscard]] std::vector<int> possible_levels(const RenderSettings& settings);

/// The deepest level that is tried to find out: deeper ones take too long before anything is shown.
inline constexpr int deepest_tried_level = 3;
/// Fills in the work of deeper levels, up to `max_level`, from that of those that were tried: it
/// goes on growing by at least half as much a level. Returns that of `max_level`.
double extrapolate_work(WorkByLevel& work, int max_level);

/// Those that are worth their work and that most_work_of_passes has room for, by the work of the
/// same blocks in each of them, in what is done `before`, and in the final one:
/// MAX 1, 2 and so on as far as they fit, or MAX 0 where not even 1 does.
[[nodiscard]] std::vector<int> choose_levels(const std::vector<int>& possible,
                                             const WorkByLevel& work, double before,
                                             double final_work);

}  // namespace asos
