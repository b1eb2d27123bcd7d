#pragma once

#include <optional>
#include <span>
#include <vector>

namespace asos {

/// One setting of a method: what its picture cost and how far off it is. Both above 0.
struct CurvePoint {
  double seconds = 0.0;
  double error = 0.0;
};

/// A value read off a curve.
struct CurveValue {
  double value = 0.0;
  bool beyond = false;  ///< past the curve's ends, where its first or last step is taken to go on
};

/// y at x on the straight line through (x0, y0) and (x1, y1) when both axes are logarithmic.
[[nodiscard]] double between_log_log(double x, double x0, double x1, double y0, double y1);

/// Seconds that a method takes to reach an error, its settings in the order of their errors, and
/// the error that it reaches in so many seconds: interpolated with both axes logarithmic. Nothing
/// where there are fewer than two points or the step to go along is flat.
[[nodiscard]] std::optional<CurveValue> seconds_at_error(std::span<const CurvePoint> curve,
                                                         double error);
[[nodiscard]] std::optional<CurveValue> error_at_seconds(std::span<const CurvePoint> curve,
                                                         double seconds);

/// The error that a render shows at a moment: that of its latest picture. `curve` is in the order
/// of its times. Nothing before the first picture.
[[nodiscard]] std::optional<double> error_shown_at(std::span<const CurvePoint> curve,
                                                   double seconds);

/// The points of a curve that no other one beats or equals in both time and error, from the
/// quickest on. Along it errors fall as times grow.
[[nodiscard]] std::vector<CurvePoint> pareto_front(std::vector<CurvePoint> points);

/// The slope of log error over log time, by least squares. Nothing with fewer than two times.
[[nodiscard]] std::optional<double> log_log_slope(std::span<const CurvePoint> curve);

/// The middle value, or the mean of the two in the middle. `values` is not empty.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace asos
