#pragma once

#include "renderer/result.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace asos {

/// A file that is written completely or not at all: the content goes to a temporary file in the
/// same folder, which then replaces the target. (Devices and pipes are written directly.) Leftovers
/// of a killed run for the same file are removed.
class OutputFile {
 public:
  /// Checks that the file can be written, without changing it, so that a long render does not end
  /// in an error that could have been reported at the start.
  [[nodiscard]] static Result<OutputFile> plan(const std::string& path);

  /// Calls `write` with the path to write to, which has the extension of the target, and then moves
  /// the result into place. A failure leaves no file.
  [[nodiscard]] Result<void> commit(
      const std::function<Result<void>(const std::string& path)>& write) const;

  /// As the user named it.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::filesystem::path target_;     // absolute, symbolic links resolved
  std::filesystem::path temporary_;  // empty: written directly
};

/// Whether two paths name the same file, which may not exist yet.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// Whether `path` ends in `extension` (with its dot), ignoring case.
[[nodiscard]] bool has_extension(const std::string& path, std::string_view extension);

}  // namespace asos
