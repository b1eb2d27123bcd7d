#include "renderer/files/leftovers.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <string>
#include <sys/types.h>
#include <system_error>
#include <vector>

namespace asos {
namespace fs = std::filesystem;
namespace {

bool is_of_dead_process(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  if (error != std::errc{} || process <= 0) return false;
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

void remove_leftovers(const fs::path& folder, std::string_view prefix) {
  std::error_code error;
  std::vector<fs::path> found;
  const fs::path where = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator at(where, error), end; !error && at != end; at.increment(error))
    if (is_of_dead_process(at->path().filename().string(), prefix)) found.push_back(at->path());
  // A file that cannot be removed does no harm.
  for (const fs::path& path : found) fs::remove(path, error);
}

}  // namespace asos
