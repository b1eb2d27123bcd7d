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
  std::string curve;    ///< name of its curve: the method, for some with a common setting
  RenderSettings settings;
};

/// Return the methods of this program that have a ladder: all, or those of a study that names no
/// methods.
[[nodiscard]] std::vector<std::string> ladder_methods();
[[nodiscard]] std::vector<std::string> default_methods();

/// Returns the ladder of a method; an error if it has none. All steps share the settings of `base`.
[[nodiscard]] Result<std::vector<LadderStep>> ladder_of(const std::string& method,
                                                        const RenderSettings& base);

/// Returns the step of a method's ladder whose progress a study records. For ASOS, it has the
/// program's default EPS and MAX. For others, it is the last step with at most 256 samples, or the
/// last one if steps have no sample counts.
[[nodiscard]] Result<LadderStep> watched_rung(const std::string& method,
                                              const RenderSettings& base);

/// Returns a step with these settings, also for published comparisons.
[[nodiscard]] LadderStep asos_rung(const std::string& method, const RenderSettings& base,
                                   int max_level, double eps);
[[nodiscard]] LadderStep sampling_rung(const std::string& method, const RenderSettings& base,
                                       int spp);

/// Returns "0", "1/256", or the number if it is no such fraction.
[[nodiscard]] std::string eps_text(double eps);

}  // namespace asos
