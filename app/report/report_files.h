#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <string>

namespace asos {

/// Creates a folder and its parents and checks that files can be written there. Errors name it.
[[nodiscard]] Result<void> make_folder(const std::string& path);

/// A scene's name for file names: its number and its stem, with '-' for other
/// characters than letters and digits.
[[nodiscard]] std::string plain_name(const std::string& scene, std::size_t number);

/// Writes a file of text into a folder.
[[nodiscard]] Result<void> write_text(const std::string& folder, const char* name,
                                      const std::string& text);

/// Removes the files of an earlier report from its folder of jobs, and nothing else.
[[nodiscard]] Result<void> clear_jobs(const std::string& folder);

/// Writes points.csv, progress.csv, report.json, plots/, pictures/ and report.html into a folder.
[[nodiscard]] Result<void> write_report(const StudyReport& report, const std::string& folder);

}  // namespace asos
