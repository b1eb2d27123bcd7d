#pragma once

#include "app/report/job_record.h"
#include "renderer/study/analysis.h"
#include "renderer/study/reference.h"

#include <string>
#include <vector>

namespace asos {

/// A scene's results with the data for its pictures.
struct SceneReport {
  SceneStudy study;
  std::vector<std::string> pictures;  ///< the EXR file of each point of the study
  SceneFacts facts;
  RegionMap regions;
  std::array<std::size_t, region_count> region_pixels{};
  Film reference;
  int passes = 0;                      ///< of the reference
  long samples = 0;                    ///< samples per pixel of the reference
  bool quiet = false;                  ///< its noise is at most a quarter of the smallest error
  std::vector<std::string> timed_out;  ///< settings that would take too long
};

/// All data of a report.
struct StudyReport {
  StudyPlan plan;
  std::vector<SceneReport> scenes;
  std::vector<Machine> machines;  ///< machines that took part, without duplicates
  std::string first;              ///< start of the first job and of the last
  std::string last;
};

/// The reference of a scene: the sum of its passes in order, up to the first at which it is quiet
/// enough for the smallest error of the scene's points.
struct ScenesReference {
  Reference reference;
  bool quiet = false;
  bool comparable = false;  ///< at least three quarters of ASOS's settings can be compared with it
};
[[nodiscard]] Result<ScenesReference> reference_of(const JobRecords& jobs,
                                                   const std::string& scene);

/// Assembles a study from its jobs. Errors: a missing job (except later passes of a reference), a
/// file that cannot be read.
[[nodiscard]] Result<StudyReport> assemble(const JobRecords& jobs);

}  // namespace asos
