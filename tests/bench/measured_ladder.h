#pragma once

#include "tests/bench/bench_support.h"
#include "tests/bench/halved_reference.h"

#include <string>
#include <vector>

namespace asos::bench {

/// Settings of a method from quick to good, and what each costs and how far off it is, which a file
/// can keep.
class MeasuredLadder {
 public:
  /// The label tells a step from the others of its ladder.
  void add(const std::string& label, const RenderSettings& settings);

  /// Renders each step once more; the time of each is the median of its runs.
  void render(Snapshot snapshot, const HalvedReference& reference);

  /// Reads points that were written for the same steps; false if the file is not there or is of
  /// others.
  [[nodiscard]] bool read(const std::string& path);
  /// A line a step: label, error, seconds.
  [[nodiscard]] Result<void> write(const std::string& path) const;

  /// Empty: neither rendered nor read.
  [[nodiscard]] const std::vector<CurvePoint>& points() const { return points_; }
  /// Whether the error of each point that was rendered is known (KnownError).
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
