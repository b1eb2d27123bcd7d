#include "renderer/study/colour_difference.h"

#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

double lab_curve(double t) {
  constexpr double edge = 6.0 / 29.0;
  return t > edge * edge * edge ? std::cbrt(t) : t / (3.0 * edge * edge) + 4.0 / 29.0;
}

double pow7(double x) {
  return std::pow(x, 7.0);
}

/// Returns the weight of high chroma: (C^7 / (C^7 + 25^7))^1/2.
double chroma_share(double chroma) {
  return std::sqrt(pow7(chroma) / (pow7(chroma) + pow7(25.0)));
}

/// Returns the hue in degrees, 0 to 360; 0 for a grey.
double hue_of(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double hue = std::atan2(b, a) / radians;
  return hue < 0.0 ? hue + 360.0 : hue;
}

struct Hues {
  double difference = 0.0;  ///< degrees, -180 to 180
  double mean = 0.0;        ///< degrees
};

/// Equations 10 and 14: the difference along the shorter arc, and the mean of that arc. A grey has
/// no hue and takes the other colour's.
Hues compare_hues(double first, double second, bool grey) {
  if (grey) return {0.0, first + second};
  const double plain = second - first;
  if (std::abs(plain) <= 180.0) return {plain, 0.5 * (first + second)};
  const double sum = first + second;
  return {plain > 180.0 ? plain - 360.0 : plain + 360.0,
          0.5 * (sum < 360.0 ? sum + 360.0 : sum - 360.0)};
}

}  // namespace

Lab lab_of_linear_srgb(glm::dvec3 c) {
  // The rows are divided by their sums, which are the white's X, Y and Z.
  const auto share = [&c](double r, double g, double b) {
    return (r * c.r + g * c.g + b * c.b) / (r + g + b);
  };
  const double x = lab_curve(share(0.4124564, 0.3575761, 0.1804375));
  const double y = lab_curve(share(0.2126729, 0.7151522, 0.0721750));
  const double z = lab_curve(share(0.0193339, 0.1191920, 0.9503041));
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double ciede2000(const Lab& first, const Lab& second) {
  // Step 1: a', C' and h'
  const double plain_chroma = 0.5 * (std::hypot(first.a, first.b) + std::hypot(second.a, second.b));
  const double stretch = 1.5 - 0.5 * chroma_share(plain_chroma);
  const double a1 = stretch * first.a;
  const double a2 = stretch * second.a;
  const double c1 = std::hypot(a1, first.b);
  const double c2 = std::hypot(a2, second.b);
  const bool grey = c1 * c2 == 0.0;
  const Hues hues = compare_hues(hue_of(a1, first.b), hue_of(a2, second.b), grey);

  // Step 2: the differences
  const double d_lightness = second.l - first.l;
  const double d_chroma = c2 - c1;
  const double d_hue = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * hues.difference * radians);

  // Step 3: their weights
  const double lightness = 0.5 * (first.l + second.l);
  const double chroma = 0.5 * (c1 + c2);
  const double hue = hues.mean;
  const double t =
      1.0 - 0.17 * std::cos((hue - 30.0) * radians) + 0.24 * std::cos(2.0 * hue * radians) +
      0.32 * std::cos((3.0 * hue + 6.0) * radians) - 0.20 * std::cos((4.0 * hue - 63.0) * radians);
  const double from_blue = (hue - 275.0) / 25.0;
  const double turn = 30.0 * std::exp(-from_blue * from_blue);
  const double from_middle = (lightness - 50.0) * (lightness - 50.0);
  const double s_lightness = 1.0 + 0.015 * from_middle / std::sqrt(20.0 + from_middle);
  const double s_chroma = 1.0 + 0.045 * chroma;
  const double s_hue = 1.0 + 0.015 * chroma * t;
  const double rotation = -std::sin(2.0 * turn * radians) * 2.0 * chroma_share(chroma);
  const double l = d_lightness / s_lightness;
  const double c = d_chroma / s_chroma;
  const double h = d_hue / s_hue;
  // Rounding may give a tiny negative sum for equal colours.
  return std::sqrt(std::fmax(0.0, l * l + c * c + h * h + rotation * c * h));
}

}  // namespace asos
