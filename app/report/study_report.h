#pragma once

#include "app/report/job_record.h"
#include "renderer/study/analysis.h"
#include "renderer/study/reference.h"

#include <string>
#include <vector>

namespace asos {

/// A scene's results with what its pictures need.
struct SceneReport {
  SceneStudy study;
  std::vector<std::string> pictures;  ///< the EXR file of each point of the study
  SceneFacts facts;
  RegionMap regions;
  std::array<std::size_t, region_count> region_pixels{};
  Film reference;
  int passes = 0;      ///< of the reference
  long samples = 0;    ///< of the reference, a pixel
  bool quiet = false;  ///< the reference's noise is a quarter of the smallest error, or less
  std::vector<std::string> given_up;  ///< settings that would have taken too long
};

/// All that a report tells.
struct StudyReport {
  StudyPlan plan;
  std::vector<SceneReport> scenes;
  std::vector<Machine> machines;  ///< that took part, each once
  std::string first;              ///< when the first job ran, and the last
  std::string last;
};

/// The reference of a scene from the passes that are there, in their order, up to the first that
/// makes it quiet enough for the smallest error of the scene's points.
struct ScenesReference {
  Reference reference;
  bool quiet = false;
  bool comparable = false;  ///< all but a quarter of ASOS's settings can be held against it
};
[[nodiscard]] Result<ScenesReference> reference_of(const JobRecords& jobs,
                                                   const std::string& scene);

/// Puts a study together from its jobs. Errors: a job that is missing but for later passes of a
/// reference, a file that cannot be read.
[[nodiscard]] Result<StudyReport> assemble(const JobRecords& jobs);

}  // namespace asos
