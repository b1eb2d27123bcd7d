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
  double cpu_seconds = 0.0;  ///< over all threads together
  double memory_mb = 0.0;
};

/// A setting of a method with all its measurements.
struct StudyPoint {
  LadderStep rung;
  std::vector<Cost> costs;  ///< one per repetition
  std::uint64_t rays = 0;
  std::uint64_t pyrays = 0;
  std::uint64_t rejected_samples = 0;
  Measures measures;
  RegionErrors regions{};
  bool under_floor = false;  ///< its error is dominated by the reference's noise: not quoted
  bool same_picture = true;  ///< all repetitions gave the same bits
  bool best = false;         ///< no setting of its method is both quicker and better

  /// Returns the median processor seconds. spread() returns half of their range divided by it.
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double spread() const;
  [[nodiscard]] double wall_seconds() const;
  [[nodiscard]] double memory_mb() const;
};

/// How a value of a comparison was obtained.
enum class Reading {
  measured,      ///< interpolated between two settings of the rival
  cheapest,      ///< the rival's quickest setting is already better: its time is used
  extrapolated,  ///< beyond the rival's measurements: its last step is continued
  unreached,     ///< too far beyond: the rival's longest time is used as a lower bound
  levelled,      ///< never: doubling its time hardly helps; its longest time is used
};
[[nodiscard]] const char* name_of(Reading reading);

/// A setting of ASOS compared with a rival at the same error (EqualTime: in the same time).
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
  double slope = 0.0;  ///< slope of log RMSE over log seconds
  int points = 0;      ///< above the floor
};

/// ASOS's own bias: the error that more time does not reduce, relative to a reference that solves
/// the rendering equation. Only an upper bound is known: the error of the best setting without the
/// reference's noise.
struct ResidualBias {
  double at_most = 0.0;     ///< RMSE
  bool levels_off = false;  ///< more time hardly helped, so the bias is about as large
  std::string setting;      ///< the best setting
};

/// The errors of a method's picture while it renders: RMSE over CPU time, without repetitions.
struct RenderCurve {
  std::string method;
  std::string setting;
  bool finished = false;  ///< false: it was stopped early
  std::vector<CurvePoint> points;
};

/// The picture of ASOS during rendering, at the time when a setting of `sobol` finishes.
struct AtMoment {
  std::string setting;   ///< of `sobol`
  double seconds = 0.0;  ///< time that this setting takes
  double sobol_rmse = 0.0;
  double asos_rmse = 0.0;    ///< of the latest picture
  double ratio = 0.0;        ///< ASOS's error over that of `sobol`; below 1: ASOS is better
  bool under_floor = false;  ///< one of the errors is dominated by noise
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
  std::optional<ResidualBias> bias;  ///< nothing if the best setting is under the floor
};

/// Returns the time that `rival` takes to reach the error of a point, with the best of its settings
/// above the floor. Returns nothing if the point is under the floor, or the rival was not measured.
[[nodiscard]] std::optional<EqualError> at_equal_error(const SceneStudy& study,
                                                       const StudyPoint& point,
                                                       const std::string& rival);

/// The number of ASOS's settings, and of those with errors under the floor, which cannot be
/// compared.
struct NoiseFloorCount {
  int settings = 0;
  int under_floor = 0;

  /// Returns whether more than a quarter of the settings are under the floor.
  [[nodiscard]] bool too_many() const { return 4 * under_floor > settings; }
};
[[nodiscard]] NoiseFloorCount incomparable(const SceneStudy& study);

/// Marks the points under the floor and the best ones, and compares. Sets all members except scene,
/// points, noise and while_rendering.
void analyse(SceneStudy& study);

/// Relative differences below this count as even.
inline constexpr double even_band = 0.05;

/// The outcome of the comparison with one rival.
struct MethodComparison {
  std::string method;  ///< the rival
  int wins = 0;        ///< of ASOS's best settings
  int evens = 0;
  int losses = 0;
  // Rows beyond the rival's measurements, by their reading; not included in the counts above.
  int extrapolated = 0;
  int unreached = 0;
  int levelled = 0;
  double beyond_median = 0.0;  ///< of the extrapolated rows
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;

  [[nodiscard]] int measured() const { return wins + evens + losses; }
  [[nodiscard]] int beyond() const { return extrapolated + unreached + levelled; }
};
/// Returns the outcome for each rival, over ASOS's best settings above the floor. Rivals without
/// rows are left out.
[[nodiscard]] std::vector<MethodComparison> verdicts(const std::vector<EqualError>& rows);
[[nodiscard]] std::vector<MethodComparison> verdicts(const std::vector<EqualTime>& rows);

}  // namespace asos
