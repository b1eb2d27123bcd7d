#include "renderer/reflections/blur_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {

BlurKernel::Trapezoid::Trapezoid(double share) {
  ramp = std::clamp(std::min(share, 1.0 - share), 0.0, 0.5);
  height = 1.0 / (1.0 - ramp);
}

double BlurKernel::Trapezoid::at(double x) const {
  const double from_side = std::min(x, 1.0 - x);
  if (from_side < 0.0) return 0.0;
  return from_side < ramp ? height * from_side / ramp : height;
}

double BlurKernel::Trapezoid::up_to(double x) const {
  if (x > 0.5) return 1.0 - up_to(1.0 - x);
  if (x <= 0.0) return 0.0;
  return x < ramp ? 0.5 * height * x * x / ramp : height * (x - 0.5 * ramp);
}

double BlurKernel::Trapezoid::where(double sum) const {
  if (sum > 0.5) return 1.0 - where(1.0 - sum);
  if (sum <= 0.0) return 0.0;
  return sum < 0.5 * height * ramp ? std::sqrt(2.0 * sum * ramp / height)
                                   : sum / height + 0.5 * ramp;
}

glm::dvec2 BlurKernel::Trapezoid::uniform_like(double lo, double hi) const {
  // Between kinks, x^2 times the trapezoid is a cubic. It is taken relative to the centre, to
  // reduce cancellation.
  const double node = 1.0 / std::sqrt(3.0), middle = 0.5 * (lo + hi);
  double sum = 0.0, first = 0.0, second = 0.0;
  const std::array<double, 4> kinks{0.0, ramp, 1.0 - ramp, 1.0};
  for (std::size_t i = 0; i + 1 < kinks.size(); ++i) {
    const double from = std::max(lo, kinks[i]), to = std::min(hi, kinks[i + 1]);
    if (!(from < to)) continue;
    const double half = 0.5 * (to - from);
    for (const double side : {-node, node}) {
      const double x = 0.5 * (from + to) + side * half;
      const double weight = half * at(x), off = x - middle;
      sum += weight, first += weight * off, second += weight * off * off;
    }
  }
  if (!(sum > 0.0)) return {lo, hi};
  const double mean = first / sum;
  const double half = std::sqrt(3.0 * std::max(0.0, second / sum - mean * mean));
  return {middle + mean - half, middle + mean + half};
}

BlurKernel::BlurKernel(glm::dvec2 share) : u_(share.x), v_(share.y) {}

// Returns the integral of up_to(u) at(v) dv along a straight side.
double BlurKernel::along(glm::dvec2 from, glm::dvec2 to) const {
  const glm::dvec2 d = to - from;
  if (d.y == 0.0) return 0.0;
  // Find where the side crosses a kink.
  std::array<double, 10> at{0.0};
  std::size_t count = 1;
  const auto add = [&](double start, double step, const Trapezoid& t) {
    for (const double kink : {0.0, t.ramp, 1.0 - t.ramp, 1.0}) {
      const double x = (kink - start) / step;
      if (x > 0.0 && x < 1.0) at[count++] = x;
    }
  };
  add(from.x, d.x, u_);
  add(from.y, d.y, v_);
  at[count++] = 1.0;
  std::sort(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(count));
  const double node = 1.0 / std::sqrt(3.0);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double middle = 0.5 * (at[i] + at[i + 1]), half = 0.5 * (at[i + 1] - at[i]);
    for (const double x : {middle - half * node, middle + half * node}) {
      const glm::dvec2 p = from + x * d;
      sum += half * u_.up_to(p.x) * v_.at(p.y);
    }
  }
  return sum * d.y;
}

double BlurKernel::integral(const LeafRegion& region) const {
  const Square& s = region.square;
  if (region.border.empty()) {
    const auto over = [&](const Trapezoid& t, double from) {
      return t.up_to(from + static_cast<double>(s.side)) - t.up_to(from);
    };
    return over(u_, static_cast<double>(s.u)) * over(v_, static_cast<double>(s.v));
  }
  double sum = 0.0;
  for (const BorderEdge& side : region.border)
    sum += along(glm::dvec2(side.from), glm::dvec2(side.to));
  return std::max(0.0, sum);
}

Bounds2 BlurKernel::uniform_like(const Bounds2& part) const {
  const glm::dvec2 lo(part.lo), hi(part.hi);
  const glm::dvec2 u = u_.uniform_like(lo.x, hi.x), v = v_.uniform_like(lo.y, hi.y);
  return {glm::vec2(glm::dvec2(u.x, v.x)), glm::vec2(glm::dvec2(u.y, v.y))};
}

glm::vec2 BlurKernel::warped(glm::vec2 p, const Bounds2& part) const {
  const auto warp = [](const Trapezoid& t, float x, float start, float end) {
    const auto lo = static_cast<double>(start), hi = static_cast<double>(end);
    if (!(lo < hi)) return start;
    const double share = (static_cast<double>(x) - lo) / (hi - lo);
    const double from = t.up_to(lo), to = t.up_to(hi);
    return static_cast<float>(std::clamp(t.where(from + share * (to - from)), lo, hi));
  };
  return {warp(u_, p.x, part.lo.x, part.hi.x), warp(v_, p.y, part.lo.y, part.hi.y)};
}

}  // namespace asos
