// Lanes of numbers with operators, their arc tangent, sine and cosine, and vectors of lanes.
// Included once for each instruction set, so it has Highway's include guard instead of `#pragma
// once`. It uses neither fused multiply-add nor approximate roots or quotients, so that all
// instruction sets give the same bits.
#if defined(ASOS_KERNELS_SIMD_MATH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_SIMD_MATH_H
#undef ASOS_KERNELS_SIMD_MATH_H
#else
#define ASOS_KERNELS_SIMD_MATH_H
#endif

#include "renderer/lights/lane_choices.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <hwy/highway.h>
#include <numbers>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct MaskOf;

/// Numbers in lanes, with the operators that Highway 1.0 lacks. `D` is Highway's tag.
template <class D>
struct LaneOf {
  using Number = hn::TFromD<D>;

  hn::Vec<D> raw;

  LaneOf() = default;
  HWY_INLINE LaneOf(hn::Vec<D> lanes) : raw(lanes) {}
  /// Copies a number to all lanes.
  template <class N>
  requires std::is_arithmetic_v<N> HWY_INLINE LaneOf(N number)
      : raw(hn::Set(D(), static_cast<Number>(number))) {}

  static HWY_INLINE std::size_t count() { return hn::Lanes(D()); }
  static HWY_INLINE LaneOf loaded(const Number* from) { return hn::LoadU(D(), from); }
  HWY_INLINE void store(Number* to) const { hn::StoreU(raw, D(), to); }
  /// Stores the lanes of a mask in a row.
  HWY_INLINE void store_if(MaskOf<D> mask, Number* to) const {
    hn::CompressStore(raw, mask.raw, D(), to);
  }

  friend HWY_INLINE LaneOf operator+(LaneOf a, LaneOf b) { return hn::Add(a.raw, b.raw); }
  friend HWY_INLINE LaneOf operator-(LaneOf a, LaneOf b) { return hn::Sub(a.raw, b.raw); }
  friend HWY_INLINE LaneOf operator*(LaneOf a, LaneOf b) { return hn::Mul(a.raw, b.raw); }
  friend HWY_INLINE LaneOf operator/(LaneOf a, LaneOf b) { return hn::Div(a.raw, b.raw); }
  friend HWY_INLINE void operator+=(LaneOf& a, LaneOf b) { a = a + b; }
  friend HWY_INLINE void operator*=(LaneOf& a, LaneOf b) { a = a * b; }
  friend HWY_INLINE LaneOf operator-(LaneOf a) { return hn::Neg(a.raw); }
  friend HWY_INLINE LaneOf sqrt(LaneOf a) { return hn::Sqrt(a.raw); }
  friend HWY_INLINE LaneOf abs(LaneOf a) { return hn::Abs(a.raw); }
  friend HWY_INLINE LaneOf floor(LaneOf a) { return hn::Floor(a.raw); }
  friend HWY_INLINE MaskOf<D> operator<(LaneOf a, LaneOf b) { return {hn::Lt(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf<D> operator<=(LaneOf a, LaneOf b) { return {hn::Le(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf<D> operator>(LaneOf a, LaneOf b) { return {hn::Gt(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf<D> operator>=(LaneOf a, LaneOf b) { return {hn::Ge(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf<D> operator==(LaneOf a, LaneOf b) { return {hn::Eq(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf<D> operator!=(LaneOf a, LaneOf b) { return {hn::Ne(a.raw, b.raw)}; }
  friend HWY_INLINE LaneOf copysign(LaneOf a, LaneOf sign) { return hn::CopySign(a.raw, sign.raw); }
  friend HWY_INLINE LaneOf min(LaneOf a, LaneOf b) { return hn::Min(a.raw, b.raw); }
  friend HWY_INLINE LaneOf max(LaneOf a, LaneOf b) { return hn::Max(a.raw, b.raw); }
  friend HWY_INLINE LaneOf clamp(LaneOf a, LaneOf least, LaneOf most) {
    return min(max(a, least), most);
  }
};

/// A vector of three coordinates in each lane.
template <class L>
struct Vec3 {
  L x, y, z;

  Vec3() = default;
  HWY_INLINE Vec3(L x_lanes, L y_lanes, L z_lanes) : x(x_lanes), y(y_lanes), z(z_lanes) {}
  /// Copies a vector to all lanes.
  template <class N>
  HWY_INLINE Vec3(const glm::vec<3, N>& v) : x(v.x), y(v.y), z(v.z) {}

  friend HWY_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend HWY_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend HWY_INLINE Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend HWY_INLINE Vec3 operator*(L s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend HWY_INLINE Vec3 operator/(const Vec3& a, L s) { return 1.0 / s * a; }
  friend HWY_INLINE L dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend HWY_INLINE L length(const Vec3& a) { return sqrt(dot(a, a)); }
  friend HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
  }
};

template <class D, class N>
HWY_INLINE Vec3<LaneOf<D>> operator*(LaneOf<D> s, const glm::vec<3, N>& v) {
  return s * Vec3<LaneOf<D>>(v);
}

/// A truth value in each lane.
template <class D>
struct MaskOf {
  using L = LaneOf<D>;

  hn::Mask<D> raw;

  /// Selects the first `count` lanes.
  static HWY_INLINE MaskOf first(std::size_t count) { return {hn::FirstN(D(), count)}; }

  friend HWY_INLINE MaskOf operator&&(MaskOf a, MaskOf b) { return {hn::And(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf operator||(MaskOf a, MaskOf b) { return {hn::Or(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf operator!=(MaskOf a, MaskOf b) { return {hn::Xor(a.raw, b.raw)}; }
  friend HWY_INLINE MaskOf operator!(MaskOf a) { return {hn::Not(a.raw)}; }
  friend HWY_INLINE bool none(MaskOf a) { return hn::AllFalse(D(), a.raw); }
  friend HWY_INLINE bool all(MaskOf a) { return hn::AllTrue(D(), a.raw); }
  friend HWY_INLINE std::size_t count(MaskOf a) { return hn::CountTrue(D(), a.raw); }

  friend HWY_INLINE L selected(MaskOf mask, L yes, L no) {
    return hn::IfThenElse(mask.raw, yes.raw, no.raw);
  }
  friend HWY_INLINE Vec3<L> selected(MaskOf mask, const Vec3<L>& yes, const Vec3<L>& no) {
    return {selected(mask, yes.x, no.x), selected(mask, yes.y, no.y), selected(mask, yes.z, no.z)};
  }
  /// Returns `a` where the mask is set, and 0 elsewhere.
  friend HWY_INLINE L where(MaskOf mask, L a) { return hn::IfThenElseZero(mask.raw, a.raw); }
  friend HWY_INLINE Vec3<L> where(MaskOf mask, const Vec3<L>& a) {
    return {where(mask, a.x), where(mask, a.y), where(mask, a.z)};
  }
};

/// c[0] + c[1] x + c[2] x^2 + ...
template <class D, std::size_t n>
HWY_INLINE LaneOf<D> polynomial(LaneOf<D> x, const hn::TFromD<D> (&c)[n]) {
  LaneOf<D> sum = c[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

/// Sine and cosine for -pi/4 to pi/4, by Taylor's series to x^9 and x^10. The error is below 1.2e-7
/// of the result.
template <class D>
HWY_INLINE SinCos<LaneOf<D>> sin_cos_of_eighth(LaneOf<D> x) {
  static constexpr float sin_terms[] = {1.0f, -1.0f / 6, 1.0f / 120, -1.0f / 5040, 1.0f / 362880};
  static constexpr float cos_terms[] = {1.0f,        -1.0f / 2,    1.0f / 24,
                                        -1.0f / 720, 1.0f / 40320, -1.0f / 3628800};
  const auto z = x * x;
  return {x * polynomial(z, sin_terms), polynomial(z, cos_terms)};
}

/// Sine and cosine for 0 to 2 pi, in double precision. The error is below 5e-16.
template <class D>
HWY_INLINE SinCos<LaneOf<D>> sin_cos(LaneOf<D> x) {
  static constexpr double sin_terms[] = {
      1.0,          -1.0 / 6,        1.0 / 120,          -1.0 / 5040,
      1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800.0, -1.0 / 1307674368000.0};
  static constexpr double cos_terms[] = {1.0,
                                         -1.0 / 2,
                                         1.0 / 24,
                                         -1.0 / 720,
                                         1.0 / 40320,
                                         -1.0 / 3628800,
                                         1.0 / 479001600,
                                         -1.0 / 87178291200.0,
                                         1.0 / 20922789888000.0};
  constexpr double half_pi = 1.5707963267948966;
  constexpr double half_pi_rest = 6.123233995736766e-17;
  const auto quarter = floor(x * (1.0 / half_pi) + 0.5);  // 0 to 4
  const auto r = x - quarter * half_pi - quarter * half_pi_rest;
  const auto z = r * r;
  const auto s = r * polynomial(z, sin_terms), c = polynomial(z, cos_terms);
  const auto first = quarter == 1.0, second = quarter == 2.0, third = quarter == 3.0;
  const auto odd = first || third;
  const auto sin = selected(odd, c, s), cos = selected(odd, s, c);
  return {selected(second || third, -sin, sin), selected(first || second, -cos, cos)};
}

/// Arc tangent in -pi to pi, in double precision; 0 for (0, 0). The error is below 1e-15 of the
/// result.
template <class D>
HWY_INLINE LaneOf<D> arc_tangent(LaneOf<D> y, LaneOf<D> x) {
  // Interpolated at Chebyshev nodes for 0 <= z <= tan^2(pi / 8), relative error 1.1e-15.
  static constexpr double terms[] = {
      0.999999999999999,    -0.33333333333221343, 0.1999999997837687,  -0.14285712660659053,
      0.11111048820585145,  -0.09089529357362555, 0.07673529098467827, -0.06505944155503311,
      0.050246342455960435, -0.025314729731942327};
  constexpr double pi = std::numbers::pi;
  const auto ax = abs(x), ay = abs(y);
  const auto low = min(ax, ay), high = max(ax, ay);
  // atan(q) = pi/4 + atan((q - 1) / (q + 1)).
  const auto turned = low > 0.41421356237309503 * high;
  const auto above = selected(turned, low - high, low);
  const auto below = selected(turned, low + high, high);
  const auto q = above / selected(below == 0.0, 1.0, below);
  auto angle = q * polynomial(q * q, terms);
  angle = selected(turned, 0.25 * pi + angle, angle);
  angle = selected(ay > ax, 0.5 * pi - angle, angle);
  angle = selected(x < 0.0, pi - angle, angle);
  return copysign(angle, y);
}

template <class D>
HWY_INLINE LaneOf<D> asin(LaneOf<D> x) {
  return arc_tangent(x, sqrt((1.0 - x) * (1.0 + x)));
}
template <class D>
HWY_INLINE LaneOf<D> hypot(LaneOf<D> x, LaneOf<D> y) {
  return sqrt(x * x + y * y);
}

/// Cube root of 0 or a positive number, in double precision. Newton's method starts at a third of
/// the exponent, in single precision.
template <class D>
HWY_INLINE LaneOf<D> cbrt(LaneOf<D> x) {
  const hn::Rebind<float, D> df;
  const hn::RebindToSigned<decltype(df)> di;
  const auto bits = hn::ConvertTo(df, hn::BitCast(di, hn::DemoteTo(df, x.raw)));
  const auto third = hn::Add(hn::Mul(bits, hn::Set(df, 1.0f / 3.0f)), hn::Set(df, 709921077.0f));
  LaneOf<D> root = hn::PromoteTo(D(), hn::BitCast(df, hn::ConvertTo(di, third)));
  for (int i = 0; i < 5; ++i) root = (2.0 * root + x / (root * root)) * (1.0 / 3.0);
  return where(x > 0.0, root);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
