#pragma once

#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// Irradiance from lights of radiance 1, or the light that a surface reflects of it, by slow
// adaptive quadrature over their surface or over directions. Independent of the renderer's closed
// forms.

namespace asos::test {

using Function = std::function<double(double)>;

struct Piece {
  double begin, end, value, error;
};

/// Gauss and Kronrod's 7 and 15 points on one interval.
[[nodiscard]] inline Piece gauss_kronrod(const Function& f, double begin, double end) {
  constexpr double nodes[8] = {
      0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
      0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
      0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
      0.207784955007898467600689403773245, 0.0};
  constexpr double kronrod[8] = {
      0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
      0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
      0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
      0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  constexpr double gauss[4] = {
      0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
      0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
  const double middle = 0.5 * (begin + end);
  const double half = 0.5 * (end - begin);
  double fine = 0.0;
  double coarse = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double sum =
        i == 7 ? f(middle) : f(middle - half * nodes[i]) + f(middle + half * nodes[i]);
    fine += kronrod[i] * sum;
    if (i % 2 == 1) coarse += gauss[i / 2] * sum;
  }
  return {begin, end, half * fine, std::abs(half * (fine - coarse))};
}

/// Integral of f from the smallest to the largest of `breaks`, to about `tolerance` relative: the
/// interval with the largest error is halved until the errors are small or there are 300 intervals.
[[nodiscard]] inline double integrate(const Function& f, std::vector<double> breaks,
                                      double tolerance) {
  std::sort(breaks.begin(), breaks.end());
  const auto less = [](const Piece& a, const Piece& b) { return a.error < b.error; };
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < breaks[i + 1]) pieces.push_back(gauss_kronrod(f, breaks[i], breaks[i + 1]));
  }
  std::make_heap(pieces.begin(), pieces.end(), less);
  for (;;) {
    double value = 0.0;
    double error = 0.0;
    for (const Piece& piece : pieces) {
      value += piece.value;
      error += piece.error;
    }
    if (pieces.empty() || error <= tolerance * std::abs(value) || pieces.size() > 300) return value;
    std::pop_heap(pieces.begin(), pieces.end(), less);
    const Piece worst = pieces.back();
    pieces.pop_back();
    const double middle = 0.5 * (worst.begin + worst.end);
    for (const Piece& half :
         {gauss_kronrod(f, worst.begin, middle), gauss_kronrod(f, middle, worst.end)}) {
      pieces.push_back(half);
      std::push_heap(pieces.begin(), pieces.end(), less);
    }
  }
}

/// begin, end, and steps of growing size around `peak` between them.
[[nodiscard]] inline std::vector<double> graded(double begin, double end, double peak,
                                                double width) {
  std::vector<double> breaks{begin, end};
  const auto add = [&](double x) {
    if (x > begin && x < end) breaks.push_back(x);
  };
  add(peak);
  for (double step = width; step < 4.0 * (end - begin) && width > 0.0; step *= 8.0) {
    add(peak - step);
    add(peak + step);
  }
  return breaks;
}

/// Clips begin..end to the range where at_zero + x slope > 0.
inline void cut(double at_zero, double slope, double& begin, double& end) {
  if (slope > 0.0) begin = std::max(begin, -at_zero / slope);
  if (slope < 0.0) end = std::min(end, -at_zero / slope);
  if (slope == 0.0 && at_zero <= 0.0) end = begin;
}

/// A flat light in the plane of `x_axis` and `y_axis` (unit, orthogonal) through `origin`: its
/// range in x at each height y from y0 to y1.
struct FlatRegion {
  glm::dvec3 origin, x_axis, y_axis;
  double y0, y1;
  std::vector<double> heights;  ///< of corners between
  std::function<std::vector<std::pair<double, double>>(double y)> spans;
  /// Heights, possibly with others, where the line at_zero + slope . (x, y) = 0 crosses its border.
  std::function<std::vector<double>(double at_zero, glm::dvec2 slope)> border_heights;
};

/// The fraction of light from a unit direction that a surface reflects. It peaks near `peak` (unit)
/// and varies over about `width` radians.
struct Response {
  std::function<double(glm::dvec3)> share;
  glm::dvec3 peak;
  double width;
};

/// Irradiance on the side that x_axis x y_axis faces; 0 on the other.
[[nodiscard]] inline double flat_oracle(const FlatRegion& region, const Receiver& receiver,
                                        double tolerance = 1e-8,
                                        const Response* response = nullptr) {
  const glm::dvec3 to_origin = region.origin - receiver.position;
  const double height = -glm::dot(to_origin, glm::cross(region.x_axis, region.y_axis));
  if (height <= 0.0) return 0.0;
  const double foot_x = -glm::dot(to_origin, region.x_axis);
  const double foot_y = -glm::dot(to_origin, region.y_axis);
  const double n_x = glm::dot(receiver.normal, region.x_axis);
  const double g_x = glm::dot(receiver.geometric, region.x_axis);

  // The response's peak in the plane, if it is there.
  glm::dvec2 peak(0.0);
  double peak_width = 0.0;
  if (response) {
    const glm::dvec3 facing = glm::cross(region.x_axis, region.y_axis);
    const double along = -height / glm::dot(response->peak, facing);
    if (along > 0.0 && along < 1e3 * glm::length(to_origin)) {
      const glm::dvec3 hit = along * response->peak - to_origin;
      peak = {glm::dot(hit, region.x_axis), glm::dot(hit, region.y_axis)};
      peak_width = response->width * along;
    }
  }

  const Function row = [&](double y) {
    const glm::dvec3 start = to_origin + y * region.y_axis;
    const double n_0 = glm::dot(receiver.normal, start);
    const double g_0 = glm::dot(receiver.geometric, start);
    const double off2 = height * height + (y - foot_y) * (y - foot_y);
    double sum = 0.0;
    for (auto [begin, end] : region.spans(y)) {
      cut(n_0, n_x, begin, end);
      cut(g_0, g_x, begin, end);
      if (!(begin < end)) continue;
      const Function along = [&](double x) {
        const double d2 = off2 + (x - foot_x) * (x - foot_x);
        const double all = height * (n_0 + x * n_x) / (d2 * d2);
        return response ? all * response->share((start + x * region.x_axis) / std::sqrt(d2)) : all;
      };
      std::vector<double> steps = graded(begin, end, foot_x, std::sqrt(off2));
      if (peak_width > 0.0) {
        const double width = std::hypot(peak_width, y - peak.y);
        for (const double x : graded(begin, end, peak.x, width)) steps.push_back(x);
      }
      sum += integrate(along, steps, 0.1 * tolerance);
    }
    return sum;
  };
  std::vector<double> breaks = graded(region.y0, region.y1, foot_y, height);
  if (peak_width > 0.0) {
    for (const double y : graded(region.y0, region.y1, peak.y, peak_width)) breaks.push_back(y);
  }
  breaks.insert(breaks.end(), region.heights.begin(), region.heights.end());
  const auto add = [&](double y) {
    if (y > region.y0 && y < region.y1) breaks.push_back(y);
  };
  // The part above the horizons may be too thin to be found otherwise: break where the horizons
  // cross the border, and where they meet.
  const double n_y = glm::dot(receiver.normal, region.y_axis);
  const double g_y = glm::dot(receiver.geometric, region.y_axis);
  const double n_0 = glm::dot(receiver.normal, to_origin);
  const double g_0 = glm::dot(receiver.geometric, to_origin);
  for (const double y : region.border_heights(n_0, {n_x, n_y})) add(y);
  for (const double y : region.border_heights(g_0, {g_x, g_y})) add(y);
  add((n_0 * g_x - g_0 * n_x) / (n_x * g_y - n_y * g_x));
  return integrate(row, breaks, tolerance);
}

[[nodiscard]] inline FlatRegion disk_region(glm::dvec3 centre, glm::dvec3 x_axis, glm::dvec3 y_axis,
                                            double radius) {
  FlatRegion region{centre, x_axis, y_axis, -radius, radius, {}, {}, {}};
  region.spans = [radius](double y) {
    const double half = std::sqrt(std::max(0.0, (radius - y) * (radius + y)));
    return std::vector<std::pair<double, double>>{{-half, half}};
  };
  region.border_heights = [radius](double at_zero, glm::dvec2 slope) -> std::vector<double> {
    const double steepness = glm::length(slope);
    const double offset = -at_zero / steepness;
    if (!(std::abs(offset) < radius)) return {};
    const double half = std::sqrt((radius - offset) * (radius + offset));
    const glm::dvec2 across = slope / steepness;
    return {offset * across.y - half * across.x, offset * across.y + half * across.x};
  };
  return region;
}

/// Outlines in the plane's coordinates; a point inside is within an odd number of them.
[[nodiscard]] inline FlatRegion polygon_region(glm::dvec3 origin, glm::dvec3 x_axis,
                                               glm::dvec3 y_axis,
                                               std::vector<std::vector<glm::dvec2>> outlines) {
  FlatRegion region{origin, x_axis, y_axis, 0.0, 0.0, {}, {}, {}};
  for (const auto& outline : outlines) {
    for (const glm::dvec2& corner : outline) region.heights.push_back(corner.y);
  }
  region.y0 = *std::min_element(region.heights.begin(), region.heights.end());
  region.y1 = *std::max_element(region.heights.begin(), region.heights.end());
  region.border_heights = [outlines](double at_zero, glm::dvec2 slope) {
    std::vector<double> heights;
    for (const auto& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 b = outline[(i + 1) % outline.size()];
        const double at_a = at_zero + glm::dot(slope, a);
        const double at_b = at_zero + glm::dot(slope, b);
        if ((at_a > 0.0) != (at_b > 0.0))
          heights.push_back(a.y + (b.y - a.y) * at_a / (at_a - at_b));
      }
    }
    return heights;
  };
  region.spans = [outlines = std::move(outlines)](double y) {
    std::vector<double> crossings;
    for (const auto& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 b = outline[(i + 1) % outline.size()];
        if ((a.y > y) != (b.y > y))
          crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<std::pair<double, double>> spans;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      spans.emplace_back(crossings[i], crossings[i + 1]);
    return spans;
  };
  return region;
}

/// Directions within `half_angle` of `axis`, integrated ring by ring.
[[nodiscard]] inline double cone_oracle(glm::dvec3 axis, double half_angle,
                                        const Receiver& receiver) {
  const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x_axis = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 y_axis = glm::cross(axis, x_axis);
  const Function ring = [&](double theta) {
    std::vector<double> breaks{0.0, 2.0 * std::numbers::pi};
    for (const glm::dvec3& n : {receiver.normal, receiver.geometric}) {
      const double swing = std::hypot(glm::dot(n, x_axis), glm::dot(n, y_axis)) * std::sin(theta);
      const double cosine = -glm::dot(n, axis) * std::cos(theta) / swing;
      if (!(std::abs(cosine) < 1.0)) continue;
      const double middle = std::atan2(glm::dot(n, y_axis), glm::dot(n, x_axis));
      for (const double angle : {middle - std::acos(cosine), middle + std::acos(cosine)})
        breaks.push_back(angle -
                         2.0 * std::numbers::pi * std::floor(angle / (2.0 * std::numbers::pi)));
    }
    std::sort(breaks.begin(), breaks.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const auto direction = [&](double phi) {
        return std::cos(theta) * axis +
               std::sin(theta) * (std::cos(phi) * x_axis + std::sin(phi) * y_axis);
      };
      const glm::dvec3 middle = direction(0.5 * (breaks[i] + breaks[i + 1]));
      if (glm::dot(middle, receiver.normal) <= 0.0 || glm::dot(middle, receiver.geometric) <= 0.0)
        continue;
      const auto cosine = [&](double phi) { return glm::dot(direction(phi), receiver.normal); };
      sum += integrate(cosine, {breaks[i], breaks[i + 1]}, 1e-10);
    }
    return sum * std::sin(theta);
  };
  // The part above the horizons may be too thin to be found otherwise.
  std::vector<double> breaks{0.0, half_angle};
  const auto add = [&](double theta) {
    if (theta > 0.0 && theta < half_angle) breaks.push_back(theta);
  };
  add(std::abs(std::asin(std::clamp(glm::dot(axis, receiver.normal), -1.0, 1.0))));
  add(std::abs(std::asin(std::clamp(glm::dot(axis, receiver.geometric), -1.0, 1.0))));
  const glm::dvec3 meet = glm::cross(receiver.normal, receiver.geometric);
  const double along = std::abs(glm::dot(meet, axis));
  add(std::atan2(glm::length(glm::cross(meet, axis)), along));
  return integrate(ring, breaks, 1e-9);
}

/// A line of one candela per metre; `lambertian`: times the sine of the angle to it.
[[nodiscard]] inline double line_oracle(glm::dvec3 begin, glm::dvec3 end, bool lambertian,
                                        const Receiver& receiver,
                                        const Response* response = nullptr) {
  const double length = glm::length(end - begin);
  const glm::dvec3 along = (end - begin) / length;
  const glm::dvec3 start = begin - receiver.position;
  double s0 = 0.0;
  double s1 = length;
  cut(glm::dot(receiver.normal, start), glm::dot(receiver.normal, along), s0, s1);
  cut(glm::dot(receiver.geometric, start), glm::dot(receiver.geometric, along), s0, s1);
  if (!(s0 < s1)) return 0.0;
  const double foot = -glm::dot(start, along);
  const double height = glm::length(start + foot * along);
  const Function at = [&](double s) {
    const glm::dvec3 p = start + s * along;
    const double d = std::hypot(height, s - foot);
    const double all = (lambertian ? height / d : 1.0) * glm::dot(receiver.normal, p) / (d * d * d);
    return response ? all * response->share(p / d) : all;
  };
  std::vector<double> breaks = graded(s0, s1, foot, height);
  if (response) {
    // The point of the line nearest to the response's peak.
    const double peak_start = glm::dot(response->peak, start);
    const double peak_along = glm::dot(response->peak, along);
    const double nearest = (foot + peak_start * peak_along) / (1.0 - peak_along * peak_along);
    const double width = response->width * glm::length(start + nearest * along);
    for (const double s : graded(s0, s1, nearest, width)) breaks.push_back(s);
  }
  return integrate(at, breaks, 1e-10);
}

}  // namespace asos::test
