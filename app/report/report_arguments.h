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
  StudyPlan plan;                    ///< complete once `look` has been taken into it
  PictureArguments look;             ///< how its scenes look: what add_look_options fills
  std::string output;                ///< a folder
  bool flicker = false;              ///< study how errors vary over the frames of an animation
  std::optional<ClipFrames> frames;  ///< those; none: its first second
  bool list_jobs = false;            ///< say what there is to do, and do nothing
  std::optional<std::size_t> job;    ///< run this one alone
  std::vector<std::string> merge;    ///< make the report from these folders of jobs
  bool quiet = false;
};

}  // namespace asos
