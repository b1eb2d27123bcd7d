#include "renderer/files/read_file.h"

#include "renderer/load_progress.h"
#include "renderer/work_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace asos {
namespace {

using tl::unexpected;

/// Closes a file descriptor on destruction.
struct OpenFile {
  int descriptor = -1;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  explicit OpenFile(const std::filesystem::path& path)
      // Without O_NONBLOCK, opening a pipe without a writer would wait forever.
      : descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

/// Reads from the file until there are `size` bytes. There are fewer if the file ends earlier, for
/// example because it became shorter.
tl::expected<void, std::string> read_up_to(std::size_t size, int descriptor, FileBytes& bytes) {
  std::size_t got = bytes.size();
  bytes.resize(size);
  constexpr std::size_t between_stops = std::size_t{1} << 24;
  while (got < bytes.size()) {
    stop_point();
    const std::size_t wanted = std::min(bytes.size() - got, between_stops);
    const ssize_t n = ::read(descriptor, bytes.data() + got, wanted);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return unexpected<std::string>(std::strerror(errno));
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  bytes.resize(got);
  return {};
}

}  // namespace

tl::expected<FileBytes, std::string> read_file(const std::filesystem::path& path,
                                               const FileRules& rules) {
  const OpenFile file(path);
  if (file.descriptor < 0)
    return unexpected(fmt::format("cannot be opened ({})", std::strerror(errno)));
  struct stat info {};
  if (::fstat(file.descriptor, &info) != 0) return unexpected<std::string>(std::strerror(errno));
  if (S_ISDIR(info.st_mode)) return unexpected<std::string>("is a directory");
  if (!S_ISREG(info.st_mode)) return unexpected<std::string>("is not a regular file");
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size > rules.most_bytes) {
    return unexpected(fmt::format("has {} bytes; the limit is {}", size, rules.most_bytes));
  }
  WorkDone::add(Work::files_read);
  FileBytes bytes;
  const auto whole = static_cast<std::size_t>(size);
  if (auto read = read_up_to(std::min(whole, FileHead::length), file.descriptor, bytes); !read)
    return unexpected(read.error());
  if (rules.fault) {
    if (std::string fault = rules.fault({bytes, size}); !fault.empty())
      return unexpected(std::move(fault));
  }
  if (auto read = read_up_to(whole, file.descriptor, bytes); !read) return unexpected(read.error());
  return bytes;
}

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

}  // namespace asos
