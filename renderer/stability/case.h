#pragma once

#include "renderer/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace asos::stability {

/// The measurement of a case: one line of the report.
struct Outcome {
  std::string quantity;  ///< the name of the figure, with its unit
  double expected = 0.0;
  double got = 0.0;
  double error = 0.0;
  double bound = 0.0;                  ///< tolerance on the error
  std::string reason;                  ///< where the bound comes from
  std::uint64_t rejected_samples = 0;  ///< not finite, left out of their pixels by the renderer
  std::uint64_t bad_pixels = 0;        ///< pixels of the pictures rendered that are not finite
};

/// A stiff or extreme scene or setting, and how to measure it. `run` may be called from any thread;
/// an error means that there is no figure, which breaks the case.
struct Case {
  std::string name;
  std::string group;
  bool quick = true;  ///< belongs to the part that takes less than a minute in all
  std::function<Result<Outcome>()> run;
};

/// A case that was run.
struct Finding {
  std::string name;
  std::string group;
  Outcome outcome;
  std::string fault;  ///< why there is no figure; empty where there is one
  double seconds = 0.0;
};

/// Whether the error is within the bound (NaN never is) and no pixel was anything but finite.
[[nodiscard]] bool holds(const Finding& finding);

/// Runs a case and takes its time. Lack of memory is a fault.
[[nodiscard]] Finding run_case(const Case& item);

/// All cases, group by group; the quick ones alone where asked. No two share group and name.
[[nodiscard]] std::vector<Case> all_cases(bool quick_only);

// One function a group.
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
