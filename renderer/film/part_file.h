#pragma once

#include "renderer/result.h"

#include <cstdio>
#include <memory>
#include <string>

namespace asos {

/// A file on its way: written beside its place under a name of its own, and renamed when it is
/// whole. Symbolic links are followed. One that is dropped before leaves nothing, and what a killed
/// process left of the same file goes. A pipe or a device is written to when all is there. Errors
/// name the place and the system's reason.
class PartFile {
 public:
  [[nodiscard]] static Result<PartFile> create(const std::string& path);

  /// To be written to; the descriptor stays this object's.
  [[nodiscard]] std::FILE* stream() const { return file_.get(); }
  /// Puts it in its place. Fails, too, where an earlier write did.
  [[nodiscard]] Result<void> commit();
  /// The error of a write that has just failed.
  [[nodiscard]] Error write_error() const;

 private:
  [[nodiscard]] Result<void> copy_through();

  // Closes the stream, and removes the file unless it has been renamed or has no name.
  struct Drop {
    std::string name;
    void operator()(std::FILE* file) const;
  };
  std::string path_;
  std::string beside_;  // empty: the place is no regular file
  std::unique_ptr<std::FILE, Drop> file_;
};

}  // namespace asos
