#pragma once

#include "app/clip_choice.h"
#include "app/picture_options.h"
#include "renderer/study/plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The arguments of `asos report`.
struct ReportArguments {
  StudyPlan plan;         ///< complete once `look` is copied into it
  PictureArguments look;  ///< the look of the scenes: filled by add_look_options
  std::string output;     ///< a folder
  bool flicker = false;   ///< study the variation of errors over the frames of an animation
  std::optional<ClipFrames> frames;  ///< its frames; none: the first second
  bool list_jobs = false;            ///< only list the jobs
  std::optional<std::size_t> job;    ///< run this one alone
  std::vector<std::string> merge;    ///< assemble the report from these folders of jobs
  bool quiet = false;
};

}  // namespace asos
