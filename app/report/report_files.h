#pragma once

#include "app/report/study_report.h"
#include "renderer/result.h"

#include <string>

namespace asos {

/// Makes a folder, with those above it, where files can be written. Errors name it.
[[nodiscard]] Result<void> make_folder(const std::string& path);

/// A scene's name as part of files' names: its number and what of it is plain.
[[nodiscard]] std::string plain_name(const std::string& scene, std::size_t number);

/// Writes a file of text into a folder.
[[nodiscard]] Result<void> write_text(const std::string& folder, const char* name,
                                      const std::string& text);

/// Removes the files that an earlier report left in its folder of jobs; nothing else.
[[nodiscard]] Result<void> clear_jobs(const std::string& folder);

/// Writes points.csv, progress.csv, report.json, plots/, pictures/ and report.html into a folder.
[[nodiscard]] Result<void> write_report(const StudyReport& report, const std::string& folder);

}  // namespace asos
