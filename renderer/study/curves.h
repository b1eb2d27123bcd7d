#pragma once

#include <optional>
#include <span>
#include <vector>

namespace asos {

/// One setting of a method: the time and the error of its picture. Both above 0.
struct CurvePoint {
  double seconds = 0.0;
  double error = 0.0;
};

/// A value read from a curve.
struct CurveValue {
  double value = 0.0;
  bool beyond = false;  ///< beyond the curve's ends, by continuing its first or last step
};

/// Returns y at x on the straight line through (x0, y0) and (x1, y1) with both axes logarithmic.
[[nodiscard]] double between_log_log(double x, double x0, double x1, double y0, double y1);

/// Returns the seconds that a method takes to reach an error, or the error that it reaches in a
/// number of seconds. Settings are in the order of their errors; interpolation is linear with both
/// axes logarithmic. Returns nothing if there are fewer than two points, or the step is flat.
[[nodiscard]] std::optional<CurveValue> seconds_at_error(std::span<const CurvePoint> curve,
                                                         double error);
[[nodiscard]] std::optional<CurveValue> error_at_seconds(std::span<const CurvePoint> curve,
                                                         double seconds);

/// Returns the error of a render at a moment: that of its latest picture. `curve` is in the order
/// of its times. Returns nothing before the first picture.
[[nodiscard]] std::optional<double> error_shown_at(std::span<const CurvePoint> curve,
                                                   double seconds);

/// Returns the points of a curve that no other one beats or equals in both time and error, starting
/// with the quickest. Errors fall as times grow.
[[nodiscard]] std::vector<CurvePoint> pareto_front(std::vector<CurvePoint> points);

/// Returns the slope of log error over log time, by least squares. Returns nothing with fewer than
/// two times.
[[nodiscard]] std::optional<double> log_log_slope(std::span<const CurvePoint> curve);

/// Returns the median, or the mean of the two middle values. `values` must not be empty.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace asos
