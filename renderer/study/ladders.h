#pragma once

#include "renderer/result.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace asos {

/// One setting of a method, a step of its ladder from quick to good.
struct Rung {
  std::string method;   ///< as on the command line
  std::string setting;  ///< in words, such as "MAX 3 EPS 1/256" or "16 spp"
  std::string curve;    ///< which steps make one line: the method, and for some what they share
  RenderSettings settings;
};

/// The methods that have a ladder and that this program has: all, or those of a study that names
/// none.
[[nodiscard]] std::vector<std::string> ladder_methods();
[[nodiscard]] std::vector<std::string> default_methods();

/// The ladder of a method; `base` gives what is the same for all. An error if it has none.
[[nodiscard]] Result<std::vector<Rung>> ladder_of(const std::string& method,
                                                  const RenderSettings& base);

/// The step of a method's ladder whose render a study watches: ASOS at the program's default EPS
/// and MAX, else the last step of at most 256 samples, or the last one where none are counted.
[[nodiscard]] Result<Rung> watched_rung(const std::string& method, const RenderSettings& base);

/// A step that is in no ladder, for a published comparison.
[[nodiscard]] Rung asos_rung(const std::string& method, const RenderSettings& base, int max_level,
                             double eps);
[[nodiscard]] Rung sampling_rung(const std::string& method, const RenderSettings& base, int spp);

/// "0", "1/256", or the number where it is no such fraction.
[[nodiscard]] std::string eps_text(double eps);

}  // namespace asos
