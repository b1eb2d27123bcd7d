#pragma once

#include "tests/bench/bench_support.h"
#include "tests/bench/halved_reference.h"

#include <string>
#include <vector>

namespace asos::bench {

/// Settings of a method in order of quality, with their measured costs and errors, which can be
/// written to a file.
class MeasuredLadder {
 public:
  /// `label` must be unique within the ladder.
  void add(const std::string& label, const RenderSettings& settings);

  /// Renders each step once more; a step's time is the median over its runs.
  void render(Snapshot snapshot, const HalvedReference& reference);

  /// Reads points written for the same steps; returns false if the file is missing or belongs to
  /// other steps.
  [[nodiscard]] bool read(const std::string& path);
  /// Writes one line per step: label, error, seconds.
  [[nodiscard]] Result<void> write(const std::string& path) const;

  /// Empty if neither rendered nor read.
  [[nodiscard]] const std::vector<CurvePoint>& points() const { return points_; }
  /// Whether the error of each rendered point is certain (KnownError).
  [[nodiscard]] const std::vector<bool>& known() const { return known_; }

 private:
  struct Step {
    std::string label;
    RenderSettings settings;
    Times times;
  };
  std::vector<Step> steps_;
  std::vector<CurvePoint> points_;
  std::vector<bool> known_;
};

}  // namespace asos::bench
