#include "renderer/kernels/lanes.h"
#include "renderer/sampling/random.h"
// Include after lane.h, so that the templates are compiled for its lanes.
#include "renderer/shading/ggx.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

// The templates of the GGX lobe, for doubles, floats and the baseline's lanes. light_kernel_test
// checks that all instruction sets give equal bits.

namespace asos::test::ggx_test {
namespace {

namespace lanes = asos::HWY_NAMESPACE;
using lanes::Lane;

/// Numbers from 0 to 1.
struct Numbers {
  explicit Numbers(std::uint64_t index) {
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = unit_pair(mix_bits(index * 16 + i)).u;
  }
  std::array<double, 8> all{};
};

constexpr std::size_t value_count = 11;

/// Returns the value of each function.
template <class L>
std::array<L, value_count> values(const Numbers& numbers) {
  const auto at = [&](std::size_t i) { return L(static_cast<float>(numbers.all[i])); };
  const L alpha = L(0.01f) + L(0.99f) * at(0) * at(0), a2 = alpha * alpha;
  const L nl = L(0.01f) + L(0.99f) * at(1), nv = L(0.01f) + L(0.99f) * at(2);
  const L nh = at(3), root_l = lanes::smith_root(nl, a2), root_v = lanes::smith_root(nv, a2);
  const auto slopes =
      lanes::GgxSlopes<L>::of(a2, at(4) * L(0.1f), {at(5), at(6), at(7)}, {at(6), at(7), at(5)});
  const L det = slopes.determinant();
  const auto normal = lanes::visible_normal<L>({at(5), at(6), nv}, alpha, a2, at(3), at(4));
  const L s = lanes::smith_shadowing(nl, root_l, nv, root_v);
  return {
      lanes::schlick_weight(nh),
      lanes::schlick(at(4), L(1), lanes::schlick_weight(nh)),
      lanes::ggx_over(a2, lanes::ggx_stretched(a2, nh), s),
      lanes::ggx_over(a2, lanes::ggx_stretched(a2, at(4), at(5), L(1) + at(6)), nv + root_v),
      lanes::smith_reached(nl, root_l, nv, root_v),
      lanes::smith_without_roots(nl, nv, alpha),
      lanes::ggx_over(lanes::GgxSlopes<L>::alpha2(det), slopes.stretched(at(1), at(2), nh, det), s),
      slopes.quadratic(at(1), at(2)),
      normal.x,
      normal.y,
      normal.z};
}

TEST(Ggx, LanesHaveTheBitsOfFloats) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const auto floats = values<float>(Numbers(i));
    const auto in_lanes = values<Lane>(Numbers(i));
    for (std::size_t k = 0; k < value_count; ++k)
      ASSERT_EQ(hwy::HWY_NAMESPACE::GetLane(in_lanes[k].raw), floats[k])
          << "value " << k << " of " << i;
  }
}

// A narrow lobe loses digits of the half vector's cosine, and a narrow anisotropic one more.
TEST(Ggx, FloatsDifferFromDoublesByRounding) {
  std::array<double, value_count> worst{};
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const auto floats = values<float>(Numbers(i));
    const auto doubles = values<double>(Numbers(i));
    for (std::size_t k = 0; k < value_count; ++k) {
      const double size = std::max(std::abs(doubles[k]), k >= 8 ? 1e-2 : 1e-9);
      worst[k] = std::max(worst[k], std::abs(static_cast<double>(floats[k]) - doubles[k]) / size);
    }
  }
  constexpr std::array<double, value_count> most{1e-6, 1e-6, 3e-4, 1.5e-6, 1e-6, 1e-6,
                                                 1e-3, 1e-6, 6e-5, 6e-5,   6e-5};
  for (std::size_t k = 0; k < value_count; ++k) {
    EXPECT_LT(worst[k], most[k]) << "value " << k;
    EXPECT_GT(worst[k], 1e-9) << "value " << k << ": floats cannot be that good";
  }
}

/// Returns the integral of `density`, of a half vector's coordinates x and z, over the hemisphere.
template <typename Density>
double over_half_vectors(double alpha, const Density& density) {
  constexpr int steps = 400, turns = 200;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    // Equal parts of the distribution times the cosine; steep normals have smaller ones.
    const double left = (i + 0.5) / steps, u = 1.0 - left * left;
    const double tangent2 = alpha * alpha * u / (1.0 - u);
    const double z = 1.0 / std::sqrt(1.0 + tangent2);
    const double stretched = lanes::ggx_stretched(alpha * alpha, z);
    const double own = alpha * alpha * std::numbers::inv_pi / (stretched * stretched) * z;
    for (int k = 0; k < turns; ++k) {
      const double turn = 2.0 * std::numbers::pi * (k + 0.5) / turns;
      const double radius = std::sqrt(1.0 - z * z);
      sum += 2.0 * left * density(radius * std::cos(turn), z) / own;
    }
  }
  return sum / (steps * turns);
}

TEST(Ggx, DensityOfVisibleNormalsHasTheIntegralOne) {
  for (const double alpha : {0.1, 0.5, 1.0}) {
    for (const double nv : {0.1, 0.5, 1.0}) {
      const double a2 = alpha * alpha, sine = std::sqrt(1.0 - nv * nv);
      const double found = over_half_vectors(alpha, [&](double x, double z) {
        // Reflection turns directions four times v.h as fast as the half vector.
        const double v_dot_h = std::max(0.0, sine * x + nv * z);
        return 4.0 * v_dot_h *
               lanes::ggx_over(a2, lanes::ggx_stretched(a2, z), nv + lanes::smith_root(nv, a2));
      });
      EXPECT_NEAR(found, 1.0, 3e-3) << alpha << " " << nv;
    }
  }
}

TEST(Ggx, AnisotropicLobeOfEqualRoughnessIsTheIsotropicOne) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Numbers numbers(i);
    const double a2 = 1e-3 + numbers.all[0], z = numbers.all[1], s = 0.1 + numbers.all[2];
    const double x = std::sqrt(1.0 - z * z);
    const lanes::GgxSlopes<double> slopes{a2, 0.0, a2};
    const double det = slopes.determinant();
    const double expected = lanes::ggx_over(a2, lanes::ggx_stretched(a2, z), s);
    EXPECT_NEAR(lanes::ggx_over(lanes::GgxSlopes<double>::alpha2(det),
                                slopes.stretched(0.6 * x, 0.8 * x, z, det), s),
                expected, 1e-9 * expected);
  }
}

}  // namespace
}  // namespace asos::test::ggx_test
