#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

// The defocusing ratio of reflected pyrays (CGF'98 section 5.1): the reflected pyray's source is
// shifted along its axis to DFR times its distance from the surface, so that the pyray widens.

namespace asos {

/// Lower limit of the ratio. At 0 the pyray would fill a half-space and its source would lie in the
/// surface. At this limit, a pyray of 2 degrees widens to 173.
inline constexpr double least_dfr = 1.0 / 1024.0;

/// Returns DFRMIN + (DFRMAX - DFRMIN) sin(alpha)^N, clamped to least_dfr to 1. `cosine` is that of
/// the incidence angle alpha, of either sign. With N = 0 it is DFRMAX everywhere, since sin(0)^0 is
/// 1. NaN stays NaN.
[[nodiscard]] double dfr_at(const DfrCurve& curve, double cosine);

/// Returns the ratios by colour, perturbed: all three are multiplied by one number from `bits`,
/// uniform in 1 - perturbation to 1 + perturbation. Products are clamped to 1, a mirror.
[[nodiscard]] std::array<double, 3> dfr_at(const Dfr& dfr, double cosine, std::uint64_t bits);

/// Returns random bits that depend on the place alone, not on the surface's side or the thread.
[[nodiscard]] std::uint64_t place_bits(glm::vec3 position);

/// Returns tan(gamma / 2) of a pyray with tan(beta / 2) = `half_tangent` that is defocused by
/// `dfr`.
[[nodiscard]] double widened_half_tangent(double half_tangent, double dfr);
/// gamma = 2 atan(tan(beta / 2) / DFR); beta in radians, 0 to pi.
[[nodiscard]] double widened_angle(double beta_rad, double dfr);
/// 100 (gamma - beta) / beta, the degree of fuzziness of table 1 and figure 7; beta above 0.
[[nodiscard]] double percentage_increase(double beta_rad, double dfr);

/// Returns the full width of a square of directions around the mirrored one that is as wide as the
/// GGX lobe. The width is twice the tangent of its half angle; `roughness` is perceptual, 0 to 1.
/// With alpha = roughness^2, facets of a slope up to r reflect the fraction r^2 / (alpha^2 + r^2)
/// of the light: half of it up to r = alpha, whose reflection has the tangent 2 alpha. A uniform
/// disk has half of its light within 1 / sqrt(2) of its radius. So a disk of radius sqrt(8) alpha
/// is as wide as the lobe, and the square of the same area is 2 sqrt(2 pi) alpha wide.
[[nodiscard]] double lobe_width(double roughness);

}  // namespace asos
