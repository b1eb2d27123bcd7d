#include "renderer/study/curves.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace asos {
namespace {

/// Reads y at x from a curve along which x falls or grows; `fields` selects x and y.
template <typename X, typename Y>
std::optional<CurveValue> read_off(std::span<const CurvePoint> curve, double x, X x_of, Y y_of) {
  if (curve.size() < 2) return std::nullopt;
  const bool falling = x_of(curve.back()) < x_of(curve.front());
  const auto passed = [&](double at) { return falling ? at > x : at < x; };
  std::size_t i = 1;
  while (i + 1 < curve.size() && passed(x_of(curve[i]))) ++i;
  const CurvePoint& a = curve[i - 1];
  const CurvePoint& b = curve[i];
  if (!(x_of(a) != x_of(b))) return std::nullopt;
  const double value = between_log_log(x, x_of(a), x_of(b), y_of(a), y_of(b));
  if (!std::isfinite(value)) return std::nullopt;
  const double first = x_of(curve.front());
  const double last = x_of(curve.back());
  return CurveValue{value, x < std::min(first, last) || x > std::max(first, last)};
}

double seconds_of(const CurvePoint& p) {
  return p.seconds;
}
double error_of(const CurvePoint& p) {
  return p.error;
}

}  // namespace

double between_log_log(double x, double x0, double x1, double y0, double y1) {
  return std::exp(std::log(y0) +
                  std::log(x / x0) / std::log(x1 / x0) * (std::log(y1) - std::log(y0)));
}

std::optional<CurveValue> seconds_at_error(std::span<const CurvePoint> curve, double error) {
  return read_off(curve, error, error_of, seconds_of);
}

std::optional<CurveValue> error_at_seconds(std::span<const CurvePoint> curve, double seconds) {
  return read_off(curve, seconds, seconds_of, error_of);
}

std::optional<double> error_shown_at(std::span<const CurvePoint> curve, double seconds) {
  const auto later = std::upper_bound(
      curve.begin(), curve.end(), seconds,
      [](double moment, const CurvePoint& point) { return moment < point.seconds; });
  if (later == curve.begin()) return std::nullopt;
  return std::prev(later)->error;
}

std::vector<CurvePoint> pareto_front(std::vector<CurvePoint> points) {
  std::sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  std::vector<CurvePoint> front;
  for (const CurvePoint& p : points)
    if (front.empty() || p.error < front.back().error) front.push_back(p);
  return front;
}

std::optional<double> log_log_slope(std::span<const CurvePoint> curve) {
  const auto count = static_cast<double>(curve.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const CurvePoint& p : curve) {
    mean_x += std::log(p.seconds) / count;
    mean_y += std::log(p.error) / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const CurvePoint& p : curve) {
    const double x = std::log(p.seconds) - mean_x;
    xx += x * x;
    xy += x * (std::log(p.error) - mean_y);
  }
  if (curve.size() < 2 || !(xx > 0.0)) return std::nullopt;
  return xy / xx;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace asos
