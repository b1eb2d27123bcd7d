#pragma once

#include "renderer/result.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace asos {

/// One setting of a method: a step of its ladder from quick to good.
struct LadderStep {
  std::string method;   ///< as on the command line
  std::string setting;  ///< in words, such as "MAX 3 EPS 1/256" or "16 spp"
  std::string curve;    ///< steps of one line: the method, and for some also a common setting
  RenderSettings settings;
};

/// Returns the methods that have a ladder and that this program has: all, or those of a study
/// without named methods.
[[nodiscard]] std::vector<std::string> ladder_methods();
[[nodiscard]] std::vector<std::string> default_methods();

/// Returns the ladder of a method; `base` has the settings common to all. An error if it has none.
[[nodiscard]] Result<std::vector<LadderStep>> ladder_of(const std::string& method,
                                                        const RenderSettings& base);

/// Returns the step of a method's ladder whose progress a study records. For ASOS, it has the
/// program's default EPS and MAX. For others, it is the last step with at most 256 samples, or the
/// last one if steps have no sample counts.
[[nodiscard]] Result<LadderStep> watched_rung(const std::string& method,
                                              const RenderSettings& base);

/// Returns a step outside of the ladders, for a published comparison.
[[nodiscard]] LadderStep asos_rung(const std::string& method, const RenderSettings& base,
                                   int max_level, double eps);
[[nodiscard]] LadderStep sampling_rung(const std::string& method, const RenderSettings& base,
                                       int spp);

/// Returns "0", "1/256", or the number if it is no such fraction.
[[nodiscard]] std::string eps_text(double eps);

}  // namespace asos
