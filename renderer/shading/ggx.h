// The GGX lobe and Schlick's Fresnel term, written once for an arithmetic type L: float, double or
// Lane (renderer/kernels/lanes.h). Included once; where Highway is included before, once for each
// instruction set.
#if defined(ASOS_SHADING_GGX_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_SHADING_GGX_H
#undef ASOS_SHADING_GGX_H
#else
#define ASOS_SHADING_GGX_H
#endif

#include "renderer/lights/lane_choices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#ifdef HWY_NAMESPACE
HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
#else
namespace asos {
#endif

/// A vector in any frame, or in that of a lobe, with the normal along z.
template <class L>
struct LobeVector {
  L x, y, z;
};

/// Two unit vectors perpendicular to a unit normal (Duff et al. 2017, "Building an Orthonormal
/// Basis, Revisited").
template <class L>
struct LobeAxes {
  LobeVector<L> right, up;
};
template <class L>
ASOS_INLINE LobeAxes<L> axes_about(L x, L y, L z) {
  using std::copysign;
  const L sign = copysign(L(1), z);
  const L a = -(L(1) / (sign + z));
  const L b = x * y * a;
  return {{L(1) + sign * x * x * a, sign * b, -(sign * x)}, {b, sign + y * y * a, -y}};
}

/// Returns (1 - cosine)^5 (Schlick 1994), with the cosine between a direction and the half vector.
template <class L>
ASOS_INLINE L schlick_weight(L cosine) {
  using std::max, std::min;
  const L m = min(max(L(1) - cosine, L(0)), L(1));
  const L m2 = m * m;
  return m2 * m2 * m;
}

/// Returns the reflectance between f0 at normal and f90 at grazing incidence, for a schlick_weight.
template <class Color, class L>
ASOS_INLINE Color schlick(const Color& f0, const Color& f90, L weight) {
  return f0 + (f90 - f0) * weight;
}

/// Returns D(h) / (2 s) of the GGX distribution D(h) = alpha^2 / (pi stretched^2) (Trowbridge and
/// Reitz 1975, Walter et al. 2007), in 1 / sr. `stretched` is a squared length of the half vector,
/// by the functions below. With s of smith_shadowing this is the lobe D V. With the sum of n.v and
/// its smith_root it is the density of directions reflected at visible normals (Heitz 2018).
template <class L>
ASOS_INLINE L ggx_over(L alpha2, L stretched, L s) {
  return alpha2 * L(0.5 * std::numbers::inv_pi) / (stretched * stretched * s);
}

/// Returns the squared length of a half vector whose part across the normal is divided by alpha,
/// times alpha^2.
template <class L>
ASOS_INLINE L ggx_stretched(L alpha2, L n_dot_h) {
  return n_dot_h * n_dot_h * (alpha2 - L(1)) + L(1);
}
/// Returns the same for a vector along the half vector of squared length `length2`, from its
/// squared part across the normal. A narrow lobe depends on the last bits of that part.
template <class L>
ASOS_INLINE L ggx_stretched(L alpha2, L across2, L along, L length2) {
  return (across2 + alpha2 * (along * along)) / length2;
}

/// Returns the root in Smith's masking function, |(alpha x, alpha y, z)| of a unit direction with
/// this cosine z.
template <class L>
ASOS_INLINE L smith_root(L cosine, L alpha2) {
  using std::sqrt;
  return sqrt(cosine * cosine * (L(1) - alpha2) + alpha2);
}

/// Returns s of ggx_over for the height-correlated masking and shadowing of Smith (Heitz 2014).
/// The roots are those of smith_root.
template <class L>
ASOS_INLINE L smith_shadowing(L n_dot_l, L root_l, L n_dot_v, L root_v) {
  return n_dot_l * root_v + n_dot_v * root_l;
}
/// Returns an approximation without roots (Hammon 2017, "PBR Diffuse Lighting for GGX+Smith
/// Microsurfaces").
template <class L>
ASOS_INLINE L smith_without_roots(L n_dot_l, L n_dot_v, L alpha) {
  return (n_dot_l + n_dot_l) * n_dot_v * (L(1) - alpha) + (n_dot_l + n_dot_v) * alpha;
}

/// Returns G2 / G1: the part of the facets visible to the viewer that the light reaches.
template <class L>
ASOS_INLINE L smith_reached(L n_dot_l, L root_l, L n_dot_v, L root_v) {
  return n_dot_l * (n_dot_v + root_v) / smith_shadowing(n_dot_l, root_l, n_dot_v, root_v);
}

/// Parts of an anisotropic lobe along one axis of the tangent plane: its stretch, and the turns of
/// a patch's normals along the patch's edges.
template <class L>
struct LobeSpread {
  L stretch, right, down;
};

/// alpha^2 by direction in the tangent plane: a symmetric matrix for an anisotropic lobe.
template <class L>
struct GgxSlopes {
  L xx, xy, yy;

  /// Adds the stretch and `turn` times the squared turns to the alpha^2 `round`.
  static ASOS_INLINE GgxSlopes of(L round, L turn, const LobeSpread<L>& x, const LobeSpread<L>& y) {
    return {round + x.stretch * x.stretch + turn * (x.right * x.right + x.down * x.down),
            x.stretch * y.stretch + turn * (x.right * y.right + x.down * y.down),
            round + y.stretch * y.stretch + turn * (y.right * y.right + y.down * y.down)};
  }

  [[nodiscard]] ASOS_INLINE L determinant() const { return xx * yy - xy * xy; }
  /// Returns the part of smith_root's square that depends on the roughness.
  [[nodiscard]] ASOS_INLINE L quadratic(L x, L y) const {
    return xx * x * x + (xy + xy) * x * y + yy * y * y;
  }
  /// Returns `stretched` of a unit half vector for ggx_over, times the root of the determinant
  /// `det`. alpha2() has the square of that factor.
  [[nodiscard]] ASOS_INLINE L stretched(L x, L y, L z, L det) const {
    return yy * (x * x) - (xy + xy) * x * y + xx * (y * y) + z * z * det;
  }
  [[nodiscard]] static ASOS_INLINE L alpha2(L det) {
    using std::sqrt;
    return sqrt(det) * det;
  }
};

/// Returns a visible normal, not unit, for a point of the unit disk and the unit direction to the
/// viewer (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", appendix A).
template <class L>
ASOS_INLINE LobeVector<L> visible_normal(const LobeVector<L>& to_viewer, L alpha_x, L alpha_y,
                                         L disk_x, L disk_y) {
  using std::max, std::sqrt;
  // Stretch the direction to roughness 1.
  const L sx = alpha_x * to_viewer.x, sy = alpha_y * to_viewer.y, sz = to_viewer.z;
  const L scale = L(1) / sqrt(max(sx * sx + sy * sy + sz * sz, L(1e-30)));
  const L vx = scale * sx, vy = scale * sy, vz = scale * sz;
  const L level2 = vx * vx + vy * vy;
  const auto steep = level2 <= L(1e-20);
  const L per_level = L(1) / sqrt(selected(steep, L(1), level2));
  const L tx = selected(steep, L(1), -(vy * per_level)), ty = selected(steep, L(0), vx * per_level);
  // Choose a point of the projection of the hemisphere's visible part.
  const L beside = max(L(0), L(1) - disk_x * disk_x);
  const L part = L(0.5) * (L(1) + vz);
  const L q = (L(1) - part) * sqrt(beside) + part * disk_y;
  const L up = sqrt(max(L(0), beside - q * q));
  const L nx = disk_x * tx - q * (ty * vz) + up * vx;
  const L ny = disk_x * ty + q * (vz * tx) + up * vy;
  const L nz = q * (vx * ty - tx * vy) + up * vz;
  return {alpha_x * nx, alpha_y * ny, max(nz, L(1e-6))};
}

#ifdef HWY_NAMESPACE
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
}  // namespace asos
#endif

#endif
