#include "renderer/shading/sheen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asos {
namespace {

/// Charlie's distribution: (2 + 1 / alpha) sin^(1 / alpha) / (2 pi).
template <typename T>
T charlie(T alpha, T sine2) {
  const T per_alpha = T(1) / alpha;
  return (T(2) + per_alpha) * std::pow(sine2, T(0.5) * per_alpha) * std::numbers::inv_pi_v<T> *
         T(0.5);
}

/// Smith's Lambda for this distribution. It has no closed form; L(x) is the paper's fit, used up to
/// a cosine of 0.5 and mirrored about it beyond.
template <typename T>
T lambda(T alpha, T cosine) {
  const T t = (T(1) - alpha) * (T(1) - alpha);
  const auto mix = [t](double rough, double smooth) {
    return static_cast<T>(rough) + t * static_cast<T>(smooth - rough);
  };
  const T a = mix(21.5473, 25.3245), b = mix(3.82987, 3.32435), c = mix(0.19823, 0.16801),
          d = mix(-1.97760, -1.27393), e = mix(-4.32054, -4.85967);
  const auto fit = [&](T x) { return a / (T(1) + b * std::pow(x, c)) + d * x + e; };
  constexpr T half = T(0.5);
  return std::exp(cosine < half ? fit(cosine) : T(2) * fit(half) - fit(T(1) - cosine));
}

/// Integrates over the hemisphere, with denser nodes at the horizon.
double integrated_albedo(double n_dot_v, double alpha) {
  constexpr int heights = 32;
  constexpr int turns = 16;  // of a half turn: both sides of the plane of view are equal
  const double sine_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
  const double lambda_v = lambda(alpha, n_dot_v);
  double sum = 0.0;
  for (int i = 0; i < heights; ++i) {
    const double t = (i + 0.5) / heights;
    const double z = t * t;
    const double weight = 2.0 * t;
    const double radius = std::sqrt((1.0 - z) * (1.0 + z));
    // The cosine and the visibility's n.l cancel out.
    const double visibility = 0.25 / ((1.0 + lambda_v + lambda(alpha, z)) * n_dot_v);
    for (int k = 0; k < turns; ++k) {
      const double angle = std::numbers::pi * (k + 0.5) / turns;
      const double hx = radius * std::cos(angle) + sine_v, hy = radius * std::sin(angle);
      const double hz = z + n_dot_v;
      const double across2 = hx * hx + hy * hy;
      sum += weight * visibility * charlie(alpha, across2 / (across2 + hz * hz));
    }
  }
  return 2.0 * std::numbers::pi * sum / (heights * turns);
}

/// The albedo at equal steps of sqrt(n.v) from 0 to 1 and of roughness from its floor to 1.
struct AlbedoTable {
  static constexpr std::size_t cosines = 40;
  static constexpr std::size_t roughnesses = 32;
  /// Rows are roughnesses, and columns n.v.
  std::array<float, cosines * roughnesses> albedo{};

  AlbedoTable() {
    for (std::size_t r = 0; r < roughnesses; ++r) {
      const double at = static_cast<double>(r) / static_cast<double>(roughnesses - 1);
      const double floor = static_cast<double>(sheen_roughness_floor);
      const double roughness = floor + (1.0 - floor) * at;
      for (std::size_t c = 0; c < cosines; ++c) {
        const double root =
            std::max(static_cast<double>(c) / static_cast<double>(cosines - 1), 1e-2);
        albedo[r * cosines + c] =
            static_cast<float>(integrated_albedo(root * root, roughness * roughness));
      }
    }
  }
};

}  // namespace

float sheen_lobe(float roughness, const BrdfAngles& angles) {
  const float alpha = roughness * roughness;
  const float nl = angles.n_dot_l, nv = angles.n_dot_v;
  const float sine2 = std::max(0.0f, 1.0f - angles.n_dot_h * angles.n_dot_h);
  const float visibility = 0.25f / ((1.0f + lambda(alpha, nv) + lambda(alpha, nl)) * nl * nv);
  return charlie(alpha, sine2) * visibility;
}

float sheen_albedo(float n_dot_v, float roughness) {
  static const AlbedoTable table;
  if (std::isnan(n_dot_v + roughness)) return n_dot_v + roughness;
  constexpr auto last_c = static_cast<float>(AlbedoTable::cosines - 1);
  constexpr auto last_r = static_cast<float>(AlbedoTable::roughnesses - 1);
  const float within =
      (std::clamp(roughness, sheen_roughness_floor, 1.0f) - sheen_roughness_floor) /
      (1.0f - sheen_roughness_floor);
  const float c = std::sqrt(std::clamp(n_dot_v, 0.0f, 1.0f)) * last_c;
  const float r = within * last_r;
  const float column = std::min(std::floor(c), last_c - 1.0f);
  const float row = std::min(std::floor(r), last_r - 1.0f);
  const auto first =
      static_cast<std::size_t>(row) * AlbedoTable::cosines + static_cast<std::size_t>(column);
  const auto along = [&](std::size_t i) {
    return std::lerp(table.albedo[i], table.albedo[i + 1], c - column);
  };
  return std::lerp(along(first), along(first + AlbedoTable::cosines), r - row);
}

}  // namespace asos
