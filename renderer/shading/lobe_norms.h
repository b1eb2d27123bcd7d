#pragma once

#include <array>
#include <cstddef>

namespace asos {

/// The integrals over all directions of brdf.h's GGX lobe times the cosine, of one viewer: what it
/// returns of a constant environment is f0 * lobe + (f90 - f0) * fresnel.
struct LobeNorms {
  float lobe = 1.0f;
  float fresnel = 0.0f;  ///< of the lobe times Schlick's (1 - v.h)^5
};

/// Both by quadrature, once, at equal steps of sqrt(n.v) and of roughness, each from 0 to 1.
/// Between them linear: within 3e-3 of the integrals from n.v 0.02 on, 5e-3 from 0.01. A mirror's,
/// of roughness 0, are 1 and (1 - n.v)^5.
struct LobeNormTable {
  static constexpr std::size_t cosines = 48;
  static constexpr std::size_t roughnesses = 40;
  /// Roughness by roughness, in each by n.v.
  std::array<float, cosines * roughnesses> lobe{};
  std::array<float, cosines * roughnesses> fresnel{};
};
[[nodiscard]] const LobeNormTable& lobe_norm_table();

/// The same of a lobe whose squared roughness differs by direction: at equal steps of sqrt(n.v), of
/// the roughness across, of sqrt((at - ab) / (1 - ab)) for the squared roughness `at` along and
/// `ab` across, and of the square root of the angle between the viewer and the direction across,
/// near which they change most; see stretched_lobe_norms. Made when it is first asked for, in about
/// 0.2 s.
struct StretchedNormTable {
  static constexpr std::size_t cosines = 24;
  static constexpr std::size_t roughnesses = 12;
  static constexpr std::size_t stretches = 14;
  static constexpr std::size_t turns = 8;
  std::array<LobeNorms, cosines * roughnesses * stretches * turns> norms{};
};
[[nodiscard]] const StretchedNormTable& stretched_norm_table();

/// Of the table, linear in each: `seen_along2` is the squared cosine of the angle, in the tangent
/// plane, between the viewer and the direction of `alpha_along`. Out of range as below.
[[nodiscard]] LobeNorms stretched_lobe_norms(float n_dot_v, float roughness, float alpha_along,
                                             float seen_along2);

/// Of the table. What lies outside of 0 to 1 counts as the nearer end; what is no number stays
/// none.
[[nodiscard]] LobeNorms lobe_norms(float n_dot_v, float roughness);

}  // namespace asos
