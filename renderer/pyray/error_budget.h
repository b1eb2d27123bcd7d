#pragma once

#include "renderer/film/tone.h"
#include "renderer/pyray/tuning.h"
#include "renderer/settings/settings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace asos {

/// The error that a pyray may have and the work that it may take: EPS and MAX of a pixel, handed
/// down to its parts and to the pyrays that these send on (CGF'98 sections 3.1 and 4.1; design
/// section 14). Weights are fractions of the root's area; intensities and errors are display
/// intensities, 1 is white.
///
/// MAX bounds the work: no cell is smaller than 4^-MAX of the root, and no part takes more than
/// four samples for each finest cell. EPS ends the work sooner.
struct ErrorBudget {
  int max_level = 4;  ///< MAX, 0 to max_level_limit
  double eps = 0.0;   ///< EPS: allowed error of the root, 0 to 1
  /// Allowed error of a leaf, if its neighbours have the same error: EPS, or the visibility
  /// threshold if that is larger. Infinite if shading is not refined.
  float tolerance = 0.0f;
  /// Slope of the tone curve where it is steepest: EPS and the tolerance are divided by it.
  double steep = 1.0;
  /// The root's weight in its pixel: 1, or that of the leaf that cast it.
  double weight = 1.0;

  /// An eighth of a step of an 8-bit picture.
  static constexpr double invisible = 1.0 / 2048.0;
  /// Default contrast of a part.
  static constexpr double usual_contrast = 0.25;

  [[nodiscard]] static ErrorBudget of(const RenderSettings& settings) {
    const AsosSettings& asos = settings.asos;
    ErrorBudget error_budget;
    error_budget.max_level = asos.max_level;
    error_budget.steep = steepness(settings.judged_tone);
    error_budget.eps = asos.eps / error_budget.steep;
    error_budget.tolerance = asos.refine_shading
                                 ? tolerance_of(error_budget.eps, error_budget.steep)
                                 : std::numeric_limits<float>::infinity();
    return error_budget;
  }

  /// Returns whether leaves are split or sampled for their shading.
  [[nodiscard]] bool refines() const { return std::isfinite(tolerance); }
  /// As `refines`, but false if MAX allows only one sample.
  [[nodiscard]] bool refines_leaves() const { return refines() && max_level > 0; }

  /// Returns the allowed standard error of a sampled part. Errors of parts are independent, so it
  /// is inversely proportional to the root of the part's weight.
  [[nodiscard]] double standard_error(double part, double intensity = 1.0) const {
    return SampleTuning::standard_errors * static_cast<double>(tolerance) /
           (intensity * std::sqrt(weight * part));
  }

  /// Returns the number of finest cells in a part.
  [[nodiscard]] double finest_cells(double part) const {
    return part * std::ldexp(1.0, 2 * max_level);
  }
  /// Returns the largest number of samples of a part: four for each finest cell, and one of a root
  /// at MAX 0; at least one.
  [[nodiscard]] double most_samples(double part) const {
    return std::max(1.0, (max_level == 0 ? 1.0 : 4.0) * finest_cells(part));
  }
  /// Returns the number of samples until a part of this contrast is converged: at most
  /// most_samples.
  [[nodiscard]] double samples(double part, double contrast) const {
    const double converged =
        std::pow(SampleTuning::error_of_one_sample * contrast / standard_error(part), 4.0 / 3.0);
    return std::min(std::max(1.0, converged), most_samples(part));
  }
  /// Returns the error of the mean of this many samples of this contrast.
  [[nodiscard]] static double error_of_samples(double samples, double contrast) {
    return SampleTuning::error_of_one_sample * contrast * std::pow(samples, -0.75);
  }
  /// Returns the number of samples of the pilot, the first round of a sampled part, which gives its
  /// variance. It is half of what usual contrast needs, but at most one for each finest cell. A
  /// power of two.
  [[nodiscard]] std::uint32_t pilot_samples(double part) const {
    const double wanted = std::min(0.5 * samples(part, usual_contrast), finest_cells(part));
    const double pilot = std::min(std::max(SampleTuning::fewest, wanted), most_samples(part));
    return std::bit_floor(static_cast<std::uint32_t>(pilot));
  }

  /// Returns the number of leaves of a part whose centre has this error, if it is split until all
  /// are within the tolerance. Each level leaves a quarter of the error.
  [[nodiscard]] double leaves(double error) const {
    const auto allowed = static_cast<double>(tolerance);
    return std::max(4.0, std::min(2.0 * error / allowed, usual_contrast / allowed));
  }

  /// Returns the largest variation of reflectance across a patch that is not integrated. The bound
  /// is small, since neighbours share the error and many lights add up.
  [[nodiscard]] float negligible_bend() const { return std::min(1.0f, tolerance / 64.0f); }

  /// Returns the number of levels that a part of this weight has used: one for each division by
  /// four. More than any MAX for a weight of 0.
  [[nodiscard]] static int levels_of(double part) {
    constexpr double most = 1024.0;  // beyond that of any positive weight
    return static_cast<int>(std::floor(std::clamp(0.5 * std::log2(1.0 / part), 0.0, most)));
  }

  /// Returns the allowance of a root that represents one part of this weight.
  [[nodiscard]] ErrorBudget of_part(double part) const {
    ErrorBudget error_budget = *this;
    error_budget.weight *= std::min(1.0, part);
    return error_budget;
  }

  /// Returns the allowance of a pyray cast by a leaf that used `levels`: the remaining levels, but
  /// at least `fewest`, and the EPS of its contribution, so that all leaves together stay within
  /// EPS.
  [[nodiscard]] ErrorBudget nested(int levels, double intensity, int fewest) const {
    ErrorBudget error_budget = *this;
    error_budget.max_level = std::clamp(max_level - levels, fewest, std::max(fewest, max_level));
    error_budget.eps = eps >= intensity ? 1.0 : eps / intensity;
    if (refines()) error_budget.tolerance = tolerance_of(error_budget.eps, steep);
    return error_budget;
  }

 private:
  [[nodiscard]] static float tolerance_of(double eps, double steep) {
    return static_cast<float>(std::max(eps, invisible / steep));
  }
};

}  // namespace asos
