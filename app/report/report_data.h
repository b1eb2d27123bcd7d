#pragma once

#include "app/report/study_report.h"
#include "renderer/study/paper_cases.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// Quotes a CSV field as in RFC 4180 if it contains a comma, a quote or a line break.
[[nodiscard]] std::string csv_field(const std::string& text);

/// points.csv: a header, then a line for each repetition of each setting. `seconds` is CPU time;
/// errors are those of renderer/study/measures.h.
[[nodiscard]] std::string points_csv(const StudyReport& report);

/// progress.csv: a header, then a line for each picture of each watched render, sorted by time.
/// `seconds` is CPU time since the render began.
[[nodiscard]] std::string progress_csv(const StudyReport& report);

/// report.json: scenes, machines and settings; the points; equal_error, equal_time and slopes over
/// all scenes.
[[nodiscard]] nlohmann::ordered_json report_json(const StudyReport& report);

/// A published case with the measurement of this program.
struct PaperRow {
  const PaperCase* published = nullptr;
  std::string scene;
  std::string method;  ///< asos or asos-published
  double asos_seconds = 0.0;
  double rival_seconds = 0.0;  ///< stochastic sampling with the paper's samples; 0: none
  double asos_rmse = 0.0;
  double rival_rmse = 0.0;
  bool under_floor = false;               ///< the error of ASOS is below the noise floor
  std::optional<EqualError> equal_error;  ///< against stochastic sampling at its best

  /// Ratio of stochastic sampling's time to that of ASOS; 0: unknown.
  [[nodiscard]] double published_ratio() const {
    return published->rival_minutes / published->asos_minutes;
  }
  [[nodiscard]] double ratio() const {
    return rival_seconds > 0.0 && asos_seconds > 0.0 ? rival_seconds / asos_seconds : 0.0;
  }
};
/// Empty if the study has no published cases.
[[nodiscard]] std::vector<PaperRow> paper_rows(const StudyReport& report);

}  // namespace asos
