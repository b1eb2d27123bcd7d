#pragma once

#include "renderer/study/curves.h"
#include "renderer/study/measures.h"
#include "renderer/study/plan.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The cost of one run of a setting.
struct Cost {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads together
  double memory_mb = 0.0;
};

/// A setting of a method with all that is known of it.
struct StudyPoint {
  Rung rung;
  std::vector<Cost> costs;  ///< one a repetition
  std::uint64_t rays = 0;
  std::uint64_t pyrays = 0;
  std::uint64_t rejected_samples = 0;
  Measures measures;
  RegionErrors regions{};
  bool under_floor = false;  ///< its error is hardly known: not quoted
  bool same_picture = true;  ///< all repetitions made the same bits
  bool best = false;         ///< no setting of its method is both quicker and better

  /// Processor seconds: the median, and half the range over it.
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double spread() const;
  [[nodiscard]] double wall_seconds() const;
  [[nodiscard]] double memory_mb() const;
};

/// How a number of a comparison was come by.
enum class Reading {
  measured,      ///< between two settings of the rival
  cheapest,      ///< the rival's quickest setting is better already: taken at that
  extrapolated,  ///< the rival was not measured so far; as its last step goes on
  unreached,     ///< nor would it get there soon: its longest time stands for it, a lower bound
  levelled,      ///< nor at all: its last doublings hardly gained; its longest time stands for it
};
[[nodiscard]] const char* name_of(Reading reading);

/// A setting of ASOS beside what a rival does at the same error, or in the same time.
struct EqualError {
  std::string setting;
  std::string method;  ///< the rival
  double rmse = 0.0;
  double asos_seconds = 0.0;
  double rival_seconds = 0.0;
  double speedup = 0.0;  ///< above 1: ASOS is quicker
  Reading reading = Reading::measured;
  bool best = false;  ///< the setting is among ASOS's best
};
struct EqualTime {
  std::string setting;
  std::string method;
  double seconds = 0.0;
  double asos_rmse = 0.0;
  double rival_rmse = 0.0;
  double ratio = 0.0;  ///< the rival's error over that of ASOS; above 1: ASOS is better
  Reading reading = Reading::measured;
  bool best = false;
};

struct Slope {
  std::string curve;
  double slope = 0.0;  ///< of log RMSE over log seconds
  int points = 0;      ///< above the floor
};

/// What no time takes away of ASOS's error: its own bias, beside a reference that is the rendering
/// equation. Known from above only, by the best of its settings, without the reference's noise.
struct OwnBias {
  double at_most = 0.0;     ///< RMSE
  bool levels_off = false;  ///< more time hardly helped: about as much is bias
  std::string setting;      ///< the best one
};

/// The errors of a method's picture while it renders: RMSE over CPU time, without repetitions.
struct RenderCurve {
  std::string method;
  std::string setting;
  bool finished = false;  ///< else its end was not waited for
  std::vector<CurvePoint> points;
};

/// The picture of ASOS while it renders, at the moment at which a setting of `sobol` has finished.
struct AtMoment {
  std::string setting;   ///< of `sobol`
  double seconds = 0.0;  ///< its time
  double sobol_rmse = 0.0;
  double asos_rmse = 0.0;    ///< of the latest picture
  double ratio = 0.0;        ///< of ASOS's error over that of `sobol`; below 1: ASOS is better
  bool under_floor = false;  ///< one of the errors is hardly known
};

/// The results for one scene.
struct SceneStudy {
  std::string scene;
  std::vector<StudyPoint> points;
  double noise = 0.0;  ///< of the reference
  double floor = 0.0;
  std::vector<EqualError> equal_error;
  std::vector<EqualTime> equal_time;
  std::vector<Slope> slopes;
  std::vector<RenderCurve> while_rendering;
  std::vector<AtMoment> at_moments;
  std::optional<OwnBias> bias;  ///< nothing where all that is better known lies under the floor
};

/// The time that `rival` takes to reach the error of a point, at the best of its settings above the
/// floor. Nothing where the point is under the floor, or the rival was not measured.
[[nodiscard]] std::optional<EqualError> at_equal_error(const SceneStudy& study,
                                                       const StudyPoint& point,
                                                       const std::string& rival);

/// How many settings of ASOS there are, and how many of them have errors under the floor, so that
/// nothing is known of them.
struct Incomparable {
  int settings = 0;
  int under_floor = 0;

  /// Whether more than a quarter of them are.
  [[nodiscard]] bool too_many() const { return 4 * under_floor > settings; }
};
[[nodiscard]] Incomparable incomparable(const SceneStudy& study);

/// Marks points under the floor and the best ones, and compares: fills all but scene, points, noise
/// and while_rendering.
void analyse(SceneStudy& study);

/// Differences below this share count as even.
inline constexpr double even_band = 0.05;

/// Whom a rival's rows favour.
struct Verdict {
  std::string method;  ///< the rival
  int wins = 0;        ///< of ASOS's best settings
  int evens = 0;
  int losses = 0;
  // Rows beyond what was measured of the rival, by their reading: counted in none of those.
  int extrapolated = 0;
  int unreached = 0;
  int levelled = 0;
  double beyond_median = 0.0;  ///< of the extrapolated ones
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;

  [[nodiscard]] int measured() const { return wins + evens + losses; }
  [[nodiscard]] int beyond() const { return extrapolated + unreached + levelled; }
};
/// By rival, over ASOS's best settings above the floor; without rows for rivals that have none.
[[nodiscard]] std::vector<Verdict> verdicts(const std::vector<EqualError>& rows);
[[nodiscard]] std::vector<Verdict> verdicts(const std::vector<EqualTime>& rows);

}  // namespace asos
