#include "renderer/scene/export/gltf_writer.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <unistd.h>

namespace asos::exporting {

namespace {

Error failure(const std::string& path, int error) {
  return {path, "cannot be written: " + std::generic_category().message(error)};
}

}  // namespace

Result<void> write_atomically(const std::string& path, const std::string& bytes) {
  // A name of our own in the same folder: a rename works only within a file system.
  static std::atomic<unsigned> counter{0};
  const std::string temporary = fmt::format("{}.{}-{}.part", path, ::getpid(), counter++);
  std::FILE* file = std::fopen(temporary.c_str(), "wbx");
  if (!file) return unexpected(failure(path, errno));

  // The close flushes, so it can be what finds the disk full.
  int error = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return {};
  std::remove(temporary.c_str());
  return unexpected(failure(path, error));
}

}  // namespace asos::exporting
