#include "renderer/shading/dfr.h"

#include "renderer/sampling/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

// Written so that NaN stays NaN.
double in_range(double ratio) {
  if (ratio < least_dfr) return least_dfr;
  return ratio > 1.0 ? 1.0 : ratio;
}

}  // namespace

double dfr_at(const DfrCurve& curve, double cosine) {
  const double c = std::abs(cosine);
  // A cosine of unit vectors may exceed 1 by rounding.
  const double sine2 = c > 1.0 ? 0.0 : (1.0 - c) * (1.0 + c);
  const double share = std::pow(sine2, 0.5 * curve.exponent);
  return in_range(share == 1.0 ? curve.max : curve.min + (curve.max - curve.min) * share);
}

std::array<double, 3> dfr_at(const Dfr& dfr, double cosine, std::uint64_t bits) {
  const double factor = 1.0 + dfr.perturbation * (2.0 * unit_pair(bits).u - 1.0);
  std::array<double, 3> ratios;
  for (std::size_t k = 0; k < ratios.size(); ++k)
    ratios[k] = in_range(factor * dfr_at(dfr.rgb[k], cosine));
  return ratios;
}

std::uint64_t place_bits(glm::vec3 position) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 3; ++k) {
    // Adding 0 turns -0 into 0.
    bits = mix_bits(bits ^ std::bit_cast<std::uint32_t>(position[k] + 0.0f));
  }
  return bits;
}

double widened_half_tangent(double half_tangent, double dfr) {
  return half_tangent / in_range(dfr);
}

double widened_angle(double beta_rad, double dfr) {
  return 2.0 * std::atan(widened_half_tangent(std::tan(0.5 * beta_rad), dfr));
}

double percentage_increase(double beta_rad, double dfr) {
  return 100.0 * (widened_angle(beta_rad, dfr) - beta_rad) / beta_rad;
}

double lobe_width(double roughness) {
  return 2.0 * std::sqrt(2.0 * std::numbers::pi) * roughness * roughness;
}

}  // namespace asos
