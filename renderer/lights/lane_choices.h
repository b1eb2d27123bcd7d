#pragma once

#include <cmath>

// Functions of the kernels' lanes (renderer/kernels/simd_math.h) for single numbers and truth
// values, so that templates serve both.

/// Inlines functions of lanes, whose instruction sets differ from those of other code.
#define ASOS_INLINE inline __attribute__((always_inline))

namespace asos {

template <class T>
ASOS_INLINE T selected(bool which, T yes, T no) {
  return which ? yes : no;
}
template <class T>
ASOS_INLINE T where(bool which, T value) {
  return which ? value : T(0);
}
ASOS_INLINE bool none(bool which) {
  return !which;
}
ASOS_INLINE bool all(bool which) {
  return which;
}

template <class L>
struct SinCos {
  L sin, cos;
};
inline SinCos<double> sin_cos(double angle) {
  return {std::sin(angle), std::cos(angle)};
}
inline double arc_tangent(double y, double x) {
  return std::atan2(y, x);
}

}  // namespace asos
