#pragma once

#include "renderer/study/plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// What `asos report` was asked for.
struct ReportArguments {
  StudyPlan plan;
  std::string output;              ///< a folder
  bool list_jobs = false;          ///< say what there is to do, and do nothing
  std::optional<std::size_t> job;  ///< run this one alone
  std::vector<std::string> merge;  ///< make the report from these folders of jobs
  bool quiet = false;
};

}  // namespace asos
