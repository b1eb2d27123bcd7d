#include "ui/dfr_curve.h"

#include "renderer/shading/dfr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace asos::ui {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Integral below x of two convolved unit-area boxes of widths `a` and `b`, centred at 0.
double below(double x, double a, double b) {
  if (b < 1e-6) return std::clamp(x / a + 0.5, 0.0, 1.0);
  const auto ramp = [](double t) { return t > 0.0 ? t * t : 0.0; };
  const double outer = 0.5 * (a + b), inner = 0.5 * (a - b);
  return (ramp(x + outer) - ramp(x + inner) - ramp(x - inner) + ramp(x - outer)) / (2.0 * a * b);
}

}  // namespace

double halfway_deg(double exponent) {
  if (!(exponent > 0.0)) return 0.0;
  return std::asin(std::pow(0.5, 1.0 / exponent)) / degree;
}

double exponent_of_halfway(double angle_deg) {
  const double sine = std::sin(std::clamp(angle_deg, 0.0, 90.0) * degree);
  if (sine <= 0.0) return 0.0;
  if (sine >= 1.0) return most_plotted_exponent;
  return std::min(std::log(0.5) / std::log(sine), most_plotted_exponent);
}

bool alike(const Dfr& dfr) {
  return dfr.rgb[0] == dfr.rgb[1] && dfr.rgb[1] == dfr.rgb[2];
}

const DfrCurve& curve_of(const Dfr& dfr, DfrChannel channel) {
  return dfr.rgb[channel == DfrChannel::all ? 0 : static_cast<std::size_t>(channel) - 1];
}

void set_curves(Dfr& dfr, DfrChannel channel, double DfrCurve::*member, double value) {
  for (std::size_t k = 0; k < dfr.rgb.size(); ++k) {
    if (channel == DfrChannel::all || static_cast<std::size_t>(channel) == k + 1)
      dfr.rgb[k].*member = value;
  }
}

double widening_axis(const Dfr& dfr) {
  // A curve is monotonic, so one of its ends is the maximum.
  double most = 10.0;
  for (const DfrCurve& curve : dfr.rgb) {
    for (const double cosine : {0.0, 1.0})
      most = std::max(most, percentage_increase(plotted_pyray_rad, dfr_at(curve, cosine)));
  }
  const double decade = std::pow(10.0, std::floor(std::log10(most) + 1e-9));
  for (const double factor : {1.0, 2.0, 5.0})
    if (most <= factor * decade * (1.0 + 1e-9)) return factor * decade;
  return 10.0 * decade;
}

glm::vec3 mirrored_bar(const Dfr& dfr, double incidence_rad, double place) {
  const double half = 0.5 * mirrored_bar_width;
  glm::vec3 seen;
  for (int k = 0; k < 3; ++k) {
    const double ratio = dfr_at(dfr.rgb[static_cast<std::size_t>(k)], std::cos(incidence_rad));
    const double lobe = 1.0 / ratio - 1.0;
    seen[k] = static_cast<float>(below(place + half, 1.0, lobe) - below(place - half, 1.0, lobe));
  }
  return seen;
}

}  // namespace asos::ui
