#pragma once

#include "tests/bench/bench_support.h"
#include "tests/bench/halved_reference.h"

#include <functional>
#include <string>
#include <vector>

namespace asos::bench {

/// One setting of a method, with the measurements of its renders.
struct MeasuredStep {
  std::string label;
  RenderSettings settings;
  Times times{};
  KnownError error{};                ///< of the last render
  double raw_rmse = 0.0;             ///< of radiance that is not clipped, where it is measured
  RenderStatistics statistics = {};  ///< of the last render
};

/// Settings of a method in order of quality, with their measured costs and errors, which can be
/// written to a file.
class MeasuredLadder {
 public:
  /// Sets the errors of a step by its picture.
  using Judge = std::function<void(MeasuredStep&, const Film&)>;

  /// Returns the ladder of a study (renderer/study/ladders.h). Labels are `prefix` and the number
  /// of samples, or EPS.
  static MeasuredLadder of_study(Method method, const RenderSettings& base,
                                 const std::string& prefix = "");

  /// `label` must be unique within the ladder.
  void add(const std::string& label, const RenderSettings& settings);

  /// Renders each step once more; a step's time is the median over its runs.
  void render(Snapshot snapshot, const Judge& judge);

  /// Reads points written for the same steps; returns false if the file is missing or belongs to
  /// other steps.
  [[nodiscard]] bool read(const std::string& path);
  /// Writes one line per step: label, error, seconds.
  [[nodiscard]] Result<void> write(const std::string& path) const;

  [[nodiscard]] const std::vector<MeasuredStep>& steps() const { return steps_; }
  /// Empty if neither rendered nor read.
  [[nodiscard]] const std::vector<CurvePoint>& points() const { return points_; }

 private:
  std::vector<MeasuredStep> steps_;
  std::vector<CurvePoint> points_;
};

}  // namespace asos::bench
