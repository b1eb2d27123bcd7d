#pragma once

#include "app/report/machine.h"
#include "renderer/film/film.h"
#include "renderer/result.h"
#include "renderer/study/analysis.h"
#include "renderer/study/plan.h"
#include "renderer/study/regions.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace asos {

/// Facts about a scene for the report.
struct SceneFacts {
  std::uint64_t triangles = 0;
  double memory_mb = 0.0;  ///< of geometry, textures and hierarchies
  std::size_t lights = 0;
  std::vector<std::string> left_out;  ///< the features that the scene does not need
};

/// The results of one job, without its picture.
struct JobRecord {
  Job job;
  Machine machine;
  std::string when;      ///< UTC, as 2026-01-31T12:00:00Z
  bool finished = true;  ///< false: it exceeded its budget or time limit, or was never started
  Cost cost;
  std::uint64_t rays = 0;
  std::uint64_t pyrays = 0;
  std::uint64_t rejected_samples = 0;
  std::string picture_hash;
  SceneFacts scene;             ///< of a job for regions
  std::vector<double> moments;  ///< of a watched render: CPU seconds of each picture
  std::string folder;           ///< where its files are
};

[[nodiscard]] nlohmann::ordered_json plan_json(const StudyPlan& plan);
[[nodiscard]] nlohmann::ordered_json machine_json(const Machine& machine);

/// Paths of the jobs of a report in `report_folder`. The files of job K are: K.json; K.exr, linear
/// radiance as floats, for the first repetition and for the reference; K-1.exr, K-2.exr and so on,
/// the pictures of a watched render; K.png, the regions, with region, split level and cause as red,
/// green and blue.
[[nodiscard]] std::string jobs_folder(const std::string& report_folder);
[[nodiscard]] std::string job_file(const std::string& folder, std::size_t id,
                                   const std::string& ending);
/// End of the file name of a watched render's picture; numbers start at 0.
[[nodiscard]] std::string moment_ending(std::size_t number);

[[nodiscard]] Result<void> write_record(const StudyPlan& plan, const JobRecord& record);

/// A study with the jobs that have been run so far.
struct JobRecords {
  StudyPlan plan;
  std::vector<Job> jobs;
  std::vector<JobRecord> records;  ///< in the order of their jobs
};

/// Reads every K.json in the folders, or in their subfolders `jobs`. All must belong to one plan,
/// and no job may occur twice. Errors name the file.
[[nodiscard]] Result<JobRecords> read_records(const std::vector<std::string>& folders);

[[nodiscard]] Result<void> write_regions(const std::string& path, const RegionMap& map);
[[nodiscard]] Result<RegionMap> read_regions(const std::string& path);

}  // namespace asos
