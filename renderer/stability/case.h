#pragma once

#include "renderer/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace asos::stability {

/// The result of a case: one line of the report.
struct Outcome {
  std::string quantity;  ///< name of the quantity, with its unit
  double expected = 0.0;
  double got = 0.0;
  double error = 0.0;
  double bound = 0.0;                  ///< tolerance on the error
  std::string reason;                  ///< derivation of the bound
  std::uint64_t rejected_samples = 0;  ///< left out by the renderer, because they are not finite
  std::uint64_t bad_pixels = 0;        ///< pixels of the rendered pictures that are not finite
};

/// A stiff or extreme scene or setting, and its measurement. `run` may be called from any thread.
/// An error means that there is no result, and the case fails.
struct Case {
  std::string name;
  std::string group;
  bool quick = true;  ///< belongs to the part that takes less than a minute in total
  std::function<Result<Outcome>()> run;
};

/// A case with its result.
struct Finding {
  std::string name;
  std::string group;
  Outcome outcome;
  std::string fault;  ///< why there is no result; empty if there is one
  double seconds = 0.0;
};

/// Returns whether the error is within the bound (NaN never is) and all pixels are finite.
[[nodiscard]] bool holds(const Finding& finding);

/// Runs a case and measures its time. Lack of memory counts as a fault.
[[nodiscard]] Finding run_case(const Case& item);

/// Returns all cases, group by group, or only the quick ones. No two have the same group and name.
[[nodiscard]] std::vector<Case> all_cases(bool quick_only);

// One function per group.
[[nodiscard]] std::vector<Case> scale_cases();
[[nodiscard]] std::vector<Case> mesh_cases();
[[nodiscard]] std::vector<Case> overlap_cases();
[[nodiscard]] std::vector<Case> view_cases();
[[nodiscard]] std::vector<Case> light_cases();
[[nodiscard]] std::vector<Case> shadow_cases();
[[nodiscard]] std::vector<Case> setting_cases();
[[nodiscard]] std::vector<Case> material_cases();
[[nodiscard]] std::vector<Case> texture_cases();
[[nodiscard]] std::vector<Case> mirror_cases();
[[nodiscard]] std::vector<Case> shape_cases();
[[nodiscard]] std::vector<Case> sky_cases();

}  // namespace asos::stability
