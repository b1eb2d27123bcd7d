// Arc tangent, sine and cosine of lanes, and vectors of lanes. Included once for each instruction
// set, so it has Highway's include guard instead of `#pragma once`. It uses neither fused
// multiply-add nor approximate roots or quotients, so that all instruction sets give the same bits.
#if defined(ASOS_KERNELS_SIMD_MATH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_SIMD_MATH_H
#undef ASOS_KERNELS_SIMD_MATH_H
#else
#define ASOS_KERNELS_SIMD_MATH_H
#endif

#include <glm/glm.hpp>

#include <cstddef>
#include <hwy/highway.h>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector of three coordinates in each lane.
template <class V>
struct Vec3 {
  V x, y, z;
};

template <class V>
HWY_INLINE Vec3<V> operator+(const Vec3<V>& a, const Vec3<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class V>
HWY_INLINE Vec3<V> operator-(const Vec3<V>& a, const Vec3<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class V>
HWY_INLINE Vec3<V> scaled(const V& s, const Vec3<V>& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
template <class V>
HWY_INLINE V dot(const Vec3<V>& a, const Vec3<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class V>
HWY_INLINE Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}
template <class M, class V>
HWY_INLINE Vec3<V> select(const M& mask, const Vec3<V>& yes, const Vec3<V>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}
/// Copies a value to all lanes.
template <class D, class T>
HWY_INLINE Vec3<hn::Vec<D>> broadcast(D d, const T& v) {
  using Lane = hn::TFromD<D>;
  return {hn::Set(d, static_cast<Lane>(v.x)), hn::Set(d, static_cast<Lane>(v.y)),
          hn::Set(d, static_cast<Lane>(v.z))};
}
template <class V>
HWY_INLINE V clamped(const V& v, const V& least, const V& most) {
  return hn::Min(hn::Max(v, least), most);
}

/// c[0] + c[1] x + c[2] x^2 + ...
template <class D, std::size_t n>
HWY_INLINE hn::Vec<D> polynomial(D d, hn::Vec<D> x, const hn::TFromD<D> (&c)[n]) {
  hn::Vec<D> sum = hn::Set(d, c[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) sum = hn::Add(hn::Mul(sum, x), hn::Set(d, c[k]));
  return sum;
}

template <class V>
struct SinCos {
  V sin, cos;
};

/// Sine and cosine for -pi/4 to pi/4, by Taylor's series to x^9 and x^10. The error is below 1.2e-7
/// of the result.
template <class D>
HWY_INLINE SinCos<hn::Vec<D>> sin_cos_of_eighth(D d, hn::Vec<D> x) {
  static constexpr float sin_terms[] = {1.0f, -1.0f / 6, 1.0f / 120, -1.0f / 5040, 1.0f / 362880};
  static constexpr float cos_terms[] = {1.0f,        -1.0f / 2,    1.0f / 24,
                                        -1.0f / 720, 1.0f / 40320, -1.0f / 3628800};
  const auto z = hn::Mul(x, x);
  return {hn::Mul(x, polynomial(d, z, sin_terms)), polynomial(d, z, cos_terms)};
}

/// Sine and cosine for 0 to 2 pi, in double precision. The error is below 5e-16.
template <class D>
HWY_INLINE SinCos<hn::Vec<D>> sin_cos(D d, hn::Vec<D> x) {
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
  const auto quarter =
      hn::Floor(hn::Add(hn::Mul(x, hn::Set(d, 1.0 / half_pi)), hn::Set(d, 0.5)));  // 0 to 4
  const auto r = hn::Sub(hn::Sub(x, hn::Mul(quarter, hn::Set(d, half_pi))),
                         hn::Mul(quarter, hn::Set(d, half_pi_rest)));
  const auto z = hn::Mul(r, r);
  const auto s = hn::Mul(r, polynomial(d, z, sin_terms));
  const auto c = polynomial(d, z, cos_terms);
  const auto one = hn::Set(d, 1.0), two = hn::Set(d, 2.0), three = hn::Set(d, 3.0);
  const auto odd = hn::Or(hn::Eq(quarter, one), hn::Eq(quarter, three));
  const auto sin = hn::IfThenElse(odd, c, s);
  const auto cos = hn::IfThenElse(odd, s, c);
  const auto sin_negative = hn::Or(hn::Eq(quarter, two), hn::Eq(quarter, three));
  const auto cos_negative = hn::Or(hn::Eq(quarter, one), hn::Eq(quarter, two));
  return {hn::IfThenElse(sin_negative, hn::Neg(sin), sin),
          hn::IfThenElse(cos_negative, hn::Neg(cos), cos)};
}

/// Arc tangent in -pi to pi, in double precision; 0 for (0, 0). The error is below 1e-15 of the
/// result.
template <class D>
HWY_INLINE hn::Vec<D> arc_tangent(D d, hn::Vec<D> y, hn::Vec<D> x) {
  // Interpolated at Chebyshev nodes for 0 <= z <= tan^2(pi / 8), relative error 1.1e-15.
  static constexpr double terms[] = {
      0.999999999999999,    -0.33333333333221343, 0.1999999997837687,  -0.14285712660659053,
      0.11111048820585145,  -0.09089529357362555, 0.07673529098467827, -0.06505944155503311,
      0.050246342455960435, -0.025314729731942327};
  constexpr double pi = std::numbers::pi;
  const auto zero = hn::Zero(d);
  const auto ax = hn::Abs(x), ay = hn::Abs(y);
  const auto low = hn::Min(ax, ay), high = hn::Max(ax, ay);
  // atan(q) = pi/4 + atan((q - 1) / (q + 1)).
  const auto turned = hn::Gt(low, hn::Mul(hn::Set(d, 0.41421356237309503), high));
  const auto above = hn::IfThenElse(turned, hn::Sub(low, high), low);
  const auto below = hn::IfThenElse(turned, hn::Add(low, high), high);
  const auto q = hn::Div(above, hn::IfThenElse(hn::Eq(below, zero), hn::Set(d, 1.0), below));
  auto angle = hn::Mul(q, polynomial(d, hn::Mul(q, q), terms));
  angle = hn::IfThenElse(turned, hn::Add(hn::Set(d, 0.25 * pi), angle), angle);
  angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(hn::Set(d, 0.5 * pi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(hn::Set(d, pi), angle), angle);
  return hn::CopySign(angle, y);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
