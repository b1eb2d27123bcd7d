#pragma once

#include "renderer/settings/settings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asos {

/// How well a pyray has to be known, and what may be spent on it: the one place that says how MAX
/// and EPS of a pixel become those of its parts and of the pyrays that these send on (CGF'98
/// section 4.1; design sections 5 and 13). Weights are shares of the root's area, intensities are
/// in units of white.
struct Budget {
  int max_level = 3;  ///< MAX, 0 to max_level_limit
  double eps = 0.0;   ///< EPS: allowed change of a root's value, 0 to 1
  /// How far one sample may be off the mean of the patch that it stands for; infinite if nothing is
  /// split for its shading.
  float tolerance = 0.0f;
  /// By how much more a difference of radiance, which is what is found, may show (see steepness):
  /// EPS and the tolerance are as much less.
  double steep = 1.0;
  /// The root's share of its pixel: 1, or that of the leaf that sent it on. Errors of samples are
  /// independent of those in the pixel's other parts, so that they may be larger by the root of it.
  double share = 1.0;

  [[nodiscard]] static Budget of(const RenderSettings& settings) {
    const AsosSettings& asos = settings.asos;
    Budget budget;
    budget.max_level = asos.max_level;
    budget.steep = steepness(settings.judged_tone);
    budget.eps = asos.eps / budget.steep;
    budget.tolerance = asos.refine_shading
                           ? tolerance_of(budget.max_level, budget.eps, budget.steep)
                           : std::numeric_limits<float>::infinity();
    return budget;
  }

  /// EPS, or a quarter of a finest cell where that is more, so that MAX alone refines shading as it
  /// refines outlines; but no less than an eighth of a step of an 8-bit picture, which nobody sees.
  [[nodiscard]] static float tolerance_of(int max_level, double eps, double steep = 1.0) {
    const double finest = std::max(std::ldexp(1.0, -2 * (max_level + 1)), invisible);
    return static_cast<float>(std::max(eps, finest / steep));
  }

  static constexpr double invisible = 1.0 / 2048.0;

  /// Whether leaves that are shaded unevenly are split as well.
  [[nodiscard]] bool refines() const { return std::isfinite(tolerance); }

  /// Whether EPS alone says how far anything may be off, and not the finest cells of a small MAX.
  [[nodiscard]] bool held_to_eps() const {
    return refines() && static_cast<double>(tolerance) <= 1.001 * eps;
  }
  /// What samples and shadow rays are held to: EPS, as exact cuts are, whatever a small MAX would
  /// allow. MAX 0 asks for no more than a sample; and MAX alone decides where EPS is too small to
  /// show.
  [[nodiscard]] Budget for_samples() const {
    Budget budget = *this;
    if (!refines() || max_level == 0 || steep * eps < invisible) return budget;
    budget.tolerance = std::min(tolerance, static_cast<float>(eps));
    while (share * std::ldexp(1.0, -2 * (budget.max_level + 1)) > eps &&
           budget.max_level < enough_levels)
      ++budget.max_level;
    return budget;
  }
  static constexpr int enough_levels = 5;  ///< that no finest cell shows

  /// What a soft shadow's edges may vary a patch by, as they are found: its bound is for an edge
  /// all along a patch, and at the worst place. Pictures are as exact by twice the tolerance, but
  /// not by twice MAX 1's; and of many lights, whose errors add up, not by twice MAX 2's.
  [[nodiscard]] float penumbra_tolerance(std::size_t lights) const {
    constexpr float of_max_2 = 1.0f / 64.0f, few = 4.0f;
    if (!refines() || max_level == 0) return 2.0f * tolerance;
    const float of_each = of_max_2 * std::min(1.0f, few / static_cast<float>(lights));
    return 2.0f * std::min(tolerance, std::max(static_cast<float>(eps), of_each));
  }

  /// How far the middle of a root may be off its mean before it is looked at more closely: a 64th
  /// of what would split it, for errors of neighbours are alike; 1: however far.
  [[nodiscard]] float negligible_bend() const { return std::min(1.0f, tolerance / 64.0f); }

  /// The standard error that a sampled part may have: half the tolerance, and more by the root of
  /// its weight, since the errors of a root's parts are independent.
  [[nodiscard]] double standard_error(double weight, double intensity = 1.0) const {
    return 0.5 * static_cast<double>(tolerance) / (intensity * std::sqrt(share * weight));
  }

  /// Rays, all over a part and a light, until the part's visibility is known to within half of EPS,
  /// and more by the root of the part's weight: the error of such points falls with the power 3/4
  /// of their number.
  [[nodiscard]] double rays(double weight, double intensity) const {
    constexpr double error_of_one = 0.35;
    const double error = 0.5 * std::max(eps, invisible) / (intensity * std::sqrt(share * weight));
    return std::pow(error_of_one / error, 4.0 / 3.0);
  }

  /// Whether that many rays cost less than an exact answer of that price.
  [[nodiscard]] bool rays_suffice(double weight, double intensity, double price) const {
    return refines() && rays(weight, intensity) <= price;
  }

  /// Samples of an uneven part that are likely to be known well enough. Its contrast: a quarter of
  /// what is displayed, and the highlights in it, which may be far brighter than white.
  [[nodiscard]] double samples_of_uneven(double weight, double highlights) const {
    constexpr double error_of_one = 0.35;
    const double contrast = usual_contrast + highlights;
    return std::pow(error_of_one * contrast / standard_error(weight), 4.0 / 3.0);
  }
  /// Whether these cost no more than that many.
  [[nodiscard]] bool samples_suffice(double weight, double price, double highlights) const {
    return samples_of_uneven(weight, highlights) <= price;
  }
  /// Samples of a part that shows many things at once until it is known as well as noise is: to
  /// twice the standard error. Its contrast: half of white.
  [[nodiscard]] double samples_of_tangle(double weight) const {
    constexpr double error_of_one = 0.35, contrast = 0.5;
    return std::pow(error_of_one * contrast / (2.0 * standard_error(weight)), 4.0 / 3.0);
  }
  /// Whether these, four for each finest cell at least, cost no more than the things one by one, at
  /// that price in all. Where a few are enough, so is one for each of the finest cells.
  [[nodiscard]] bool samples_suffice_for_parts(double weight, double price) const {
    constexpr double few = 16.0, a_cell = 4.0;
    if (!refines() || steep * eps < invisible) return false;
    const Budget budget = for_samples();
    const double samples = budget.samples_of_tangle(weight);
    return samples >= few && std::max(samples, a_cell * budget.finest_cells(weight)) <= price;
  }
  /// Leaves of a part that is split until it is even: their error falls with their number.
  [[nodiscard]] double leaves_of_uneven() const {
    return usual_contrast / static_cast<double>(tolerance);
  }
  /// Leaves of a part whose middle is off its mean by no more than `error` until all of them
  /// together are off by half of the tolerance, where each level leaves a quarter.
  [[nodiscard]] double leaves_of_bent(double error) const {
    return std::min(std::max(4.0, 2.0 * error / static_cast<double>(tolerance)),
                    leaves_of_uneven());
  }
  static constexpr double usual_contrast = 0.25;

  /// How many finest cells a part stands for.
  [[nodiscard]] double finest_cells(double weight) const {
    return weight * std::ldexp(1.0, 2 * max_level);
  }
  /// Samples that take the place of so many for each finest cell: a power of two, `fewest` at
  /// least.
  [[nodiscard]] std::uint32_t samples(double weight, double a_finest_cell,
                                      std::uint32_t fewest) const {
    return std::bit_ceil(
        std::max(fewest, static_cast<std::uint32_t>(a_finest_cell * finest_cells(weight))));
  }

  /// The levels that a part of this weight has used up: one for each quarter.
  [[nodiscard]] static int levels_of(double weight) {
    return std::max(0, static_cast<int>(std::floor(0.5 * std::log2(1.0 / weight))));
  }

  /// The budget of what stands for a part of this weight alone.
  [[nodiscard]] Budget of_part(double weight) const {
    Budget budget = *this;
    budget.share *= std::min(1.0, weight);
    return budget;
  }

  /// The budget of a pyray that a leaf sends on, which used up `levels`: those that are left, but
  /// `fewest`; and the EPS of what it contributes, so that all leaves together stay within EPS.
  [[nodiscard]] Budget nested(int levels, double intensity, int fewest) const {
    Budget budget = *this;
    budget.max_level = std::clamp(max_level - levels, fewest, std::max(fewest, max_level));
    budget.eps = eps >= intensity ? 1.0 : eps / intensity;
    if (refines()) budget.tolerance = tolerance_of(budget.max_level, budget.eps, steep);
    return budget;
  }
};

}  // namespace asos
