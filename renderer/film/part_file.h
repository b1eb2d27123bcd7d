#pragma once

#include "renderer/result.h"

#include <cstdio>
#include <memory>
#include <string>

namespace asos {

/// A file being written: it has a temporary name in the target folder, and is renamed when it is
/// complete. Symbolic links are followed. Dropping an incomplete one removes it; leftovers of
/// killed processes for the same target are removed, too. A pipe or a device gets the data at the
/// end. Errors name the target and the system's reason.
class PartFile {
 public:
  [[nodiscard]] static Result<PartFile> create(const std::string& path);

  /// The stream to write to; this object keeps the ownership.
  [[nodiscard]] std::FILE* stream() const { return file_.get(); }
  /// Gives the file its final name. Also fails if an earlier write failed.
  [[nodiscard]] Result<void> commit();
  /// Returns the error of a write that has just failed.
  [[nodiscard]] Error write_error() const;

 private:
  [[nodiscard]] Result<void> copy_through();

  // Closes the stream, and removes the file unless it was renamed or has no name.
  struct Drop {
    std::string name;
    void operator()(std::FILE* file) const;
  };
  std::string path_;
  std::string beside_;  // empty: the target is no regular file
  std::unique_ptr<std::FILE, Drop> file_;
};

}  // namespace asos
