#pragma once

#include "app/report/compared_scene.h"
#include "app/report/job_record.h"

#include <functional>
#include <optional>
#include <string>

namespace asos {

/// Runs jobs of a plan and writes their files into a folder. Keeps the scene open between jobs.
class JobRunner {
 public:
  /// `stop` is called often; once it returns true, `run` ends with an error.
  JobRunner(StudyPlan plan, std::string jobs_folder, std::function<bool()> stop);

  /// Renders and writes. Gives up a point, a watched render or a later pass of the reference after
  /// `seconds`, and notes that in the record. Errors: a scene that cannot be opened or that the
  /// method cannot render, a file that cannot be written, a stop.
  [[nodiscard]] Result<JobRecord> run(const Job& job, double seconds);

  /// Writes a record of a point that was never started.
  [[nodiscard]] Result<JobRecord> give_up(const Job& job) const;

 private:
  [[nodiscard]] JobRecord record_of(const Job& job) const;
  [[nodiscard]] Result<void> open(const StudyScene& subject);
  /// Renders, fills in the record and writes the pictures. `stop` ends the render.
  [[nodiscard]] Result<void> render(JobRecord& record, const std::function<bool()>& stop) const;
  [[nodiscard]] Result<void> watch(JobRecord& record, const std::function<bool()>& stop) const;
  [[nodiscard]] Result<void> write_picture(const JobRecord& record, const Film& film) const;

  StudyPlan plan_;
  std::string folder_;
  std::function<bool()> stop_;
  Machine machine_ = this_machine();
  StudyScene open_subject_;
  std::optional<ComparedScene> open_;
};

}  // namespace asos
