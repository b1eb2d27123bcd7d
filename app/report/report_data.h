#pragma once

#include "app/report/study_report.h"
#include "renderer/study/paper_cases.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// As RFC 4180 has it: in quotes where a comma, a quote or a line's end is inside.
[[nodiscard]] std::string csv_field(const std::string& text);

/// points.csv: a header, then a line for each repetition of each setting. `seconds` are processor
/// seconds of all threads together; errors are those of the measures of renderer/study/measures.h.
[[nodiscard]] std::string points_csv(const StudyReport& report);

/// progress.csv: a header, then a line for each picture of each render that was watched, in the
/// order of their times. `seconds` are CPU seconds of all workers since the render began.
[[nodiscard]] std::string progress_csv(const StudyReport& report);

/// report.json: what was compared, on what, with what settings; the points; equal_error, equal_time
/// and slopes over all scenes.
[[nodiscard]] nlohmann::ordered_json report_json(const StudyReport& report);

/// A published case beside what was measured here.
struct PaperRow {
  const PaperCase* published = nullptr;
  std::string scene;
  std::string method;  ///< asos or asos-published
  double asos_seconds = 0.0;
  double rival_seconds = 0.0;  ///< stochastic sampling at the paper's samples; 0: none
  double asos_rmse = 0.0;
  double rival_rmse = 0.0;
  bool under_floor = false;               ///< the error of ASOS is hardly known
  std::optional<EqualError> equal_error;  ///< beside stochastic sampling at its best

  /// Ratio of stochastic sampling's time to that of ASOS; 0: none was published, or can be told.
  [[nodiscard]] double published_ratio() const {
    return published->rival_minutes / published->asos_minutes;
  }
  [[nodiscard]] double ratio() const {
    return rival_seconds > 0.0 && asos_seconds > 0.0 ? rival_seconds / asos_seconds : 0.0;
  }
};
/// Empty where the study has none.
[[nodiscard]] std::vector<PaperRow> paper_rows(const StudyReport& report);

}  // namespace asos
