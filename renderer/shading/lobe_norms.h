#pragma once

#include <array>
#include <cstddef>

namespace asos {

/// Integrals over all directions of the GGX lobe in brdf.h times the cosine, for one viewer. The
/// lobe reflects f0 * lobe + (f90 - f0) * fresnel of a constant environment.
struct LobeNorms {
  float lobe = 1.0f;
  float fresnel = 0.0f;  ///< integral of the lobe times Schlick's (1 - v.h)^5
};

/// A table of both integrals by quadrature, at equal steps of sqrt(n.v) and of roughness, each from
/// 0 to 1. Interpolation is linear; its error is 3e-3 from n.v 0.02 on and 5e-3 from 0.01. A
/// mirror, of roughness 0, has 1 and (1 - n.v)^5.
struct LobeNormTable {
  static constexpr std::size_t cosines = 48;
  static constexpr std::size_t roughnesses = 40;
  /// Rows are roughnesses, and columns n.v.
  std::array<float, cosines * roughnesses> lobe{};
  std::array<float, cosines * roughnesses> fresnel{};
};
[[nodiscard]] const LobeNormTable& lobe_norm_table();

/// The same table for an anisotropic lobe with the squared roughness `at` along and `ab` across. It
/// has equal steps of four quantities:
/// - sqrt(n.v)
/// - the roughness across
/// - sqrt((at - ab) / (1 - ab))
/// - the square root of the angle between the viewer and the direction across, near which the
///   integrals change most
/// See stretched_lobe_norms. It is computed at first use, in about 0.2 s.
struct StretchedNormTable {
  static constexpr std::size_t cosines = 24;
  static constexpr std::size_t roughnesses = 12;
  static constexpr std::size_t stretches = 14;
  static constexpr std::size_t turns = 8;
  std::array<LobeNorms, cosines * roughnesses * stretches * turns> norms{};
};
[[nodiscard]] const StretchedNormTable& stretched_norm_table();

/// Interpolates the table linearly in each quantity. `seen_along2` is the squared cosine of the
/// angle, in the tangent plane, between the viewer and the direction of `alpha_along`. Values out
/// of range are handled as in lobe_norms.
[[nodiscard]] LobeNorms stretched_lobe_norms(float n_dot_v, float roughness, float alpha_along,
                                             float seen_along2);

/// Interpolates the table. Values outside of 0 to 1 count as the nearer end; NaN stays NaN.
[[nodiscard]] LobeNorms lobe_norms(float n_dot_v, float roughness);

}  // namespace asos
