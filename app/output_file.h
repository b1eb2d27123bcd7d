#pragma once

#include "renderer/result.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace asos {

/// A file that is written whole or not at all: the content goes to a temporary file beside it,
/// which then takes its place. (Devices and pipes are written directly.) What a run that was killed
/// has left of the same file is removed.
class OutputFile {
 public:
  /// Checks that the file can be written, without touching what is there, so that a long render
  /// does not end in an error that was there from the start.
  [[nodiscard]] static Result<OutputFile> plan(const std::string& path);

  /// Calls `write` with the path to write to, which ends like the planned one, and puts the result
  /// in place. On failure nothing is left behind.
  [[nodiscard]] Result<void> commit(
      const std::function<Result<void>(const std::string& path)>& write) const;

  /// As the user named it.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::filesystem::path target_;     // absolute, symbolic links resolved
  std::filesystem::path temporary_;  // empty: written directly
};

/// Whether two paths name the same file, which need not exist.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// Whether `path` ends in `extension` (with its dot), whatever the case of its letters.
[[nodiscard]] bool has_extension(const std::string& path, std::string_view extension);

}  // namespace asos
