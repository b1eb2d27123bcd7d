#include "ui/file_watch.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace asos::ui {

FileStamp FileStamp::of(const std::string& path) {
  std::error_code error;
  State state;
  state.written = std::filesystem::last_write_time(path, error);
  if (!error) state.size = std::filesystem::file_size(path, error);
  return {path, error ? std::nullopt : std::optional(state)};
}

bool FileWatch::changed(const std::vector<FileStamp>& read, double now_seconds) {
  if (looked_seconds_ && now_seconds - *looked_seconds_ < period_seconds) return false;
  looked_seconds_ = now_seconds;
  std::vector<FileStamp> found;
  bool gone = false;
  for (const FileStamp& stamp : read) {
    found.push_back(FileStamp::of(stamp.path));
    // A file may be missing for a moment while it is replaced.
    gone = gone || (stamp.state && !found.back().state);
  }
  const bool still = found == seen_;
  seen_ = std::move(found);
  return still && !gone && seen_ != read;
}

double FileWatch::seconds_to_look(double now_seconds) const {
  return looked_seconds_ ? std::max(0.0, *looked_seconds_ + period_seconds - now_seconds) : 0.0;
}

}  // namespace asos::ui
