#include "renderer/stability/case.h"

#include <chrono>
#include <iterator>
#include <new>
#include <utility>

namespace asos::stability {

bool holds(const Finding& finding) {
  return finding.fault.empty() && finding.outcome.error <= finding.outcome.bound &&
         finding.outcome.bad_pixels == 0;
}

Finding run_case(const Case& item) {
  Finding finding;
  finding.name = item.name;
  finding.group = item.group;
  const auto start = std::chrono::steady_clock::now();
  try {
    Result<Outcome> outcome = item.run();
    if (outcome) {
      finding.outcome = *std::move(outcome);
    } else {
      finding.fault = outcome.error().message();
    }
  } catch (const std::bad_alloc&) {
    finding.fault = "not enough memory";
  }
  finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return finding;
}

std::vector<Case> all_cases(bool quick_only) {
  std::vector<Case> cases;
  for (const auto group :
       {scale_cases, mesh_cases, overlap_cases, view_cases, light_cases, shadow_cases,
        setting_cases, material_cases, texture_cases, mirror_cases, shape_cases, sky_cases}) {
    for (Case& item : group()) {
      if (item.quick || !quick_only) cases.push_back(std::move(item));
    }
  }
  return cases;
}

}  // namespace asos::stability
