#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <unistd.h>

namespace asos {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Error system_error(const std::string& path, const char* what, int code) {
  return {path, fmt::format("{} ({})", what, std::generic_category().message(code))};
}

}  // namespace

Result<void> write_file_atomically(const std::string& path,
                                   const std::vector<std::uint8_t>& bytes) {
  // The name beside it is this process's and this call's own.
  static std::atomic<unsigned> serial{0};
  const std::string beside = fmt::format("{}.{}-{}.part", path, ::getpid(), serial++);
  File file(std::fopen(beside.c_str(), "wbx"));
  if (!file) return unexpected(system_error(path, "cannot be written", errno));

  const bool wrote = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                     std::fflush(file.get()) == 0;
  int code = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (wrote && !closed) code = errno;
  if (!wrote || !closed) {
    std::remove(beside.c_str());
    return unexpected(system_error(path, "could not be written to the end", code));
  }
  if (std::rename(beside.c_str(), path.c_str()) != 0) {
    code = errno;
    std::remove(beside.c_str());
    return unexpected(system_error(path, "cannot be replaced", code));
  }
  return {};
}

}  // namespace asos
