#include "ui/file_watch.h"

#include <algorithm>
#include <system_error>

namespace asos {

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::string& source) {
  std::error_code error;
  Stamp stamp;
  stamp.written = std::filesystem::last_write_time(source, error);
  if (error) return std::nullopt;
  stamp.size = std::filesystem::file_size(source, error);
  return error ? std::nullopt : std::optional(stamp);
}

bool FileWatch::changed(const std::string& source, double now_seconds) {
  if (source != source_) {
    source_ = source;
    known_ = seen_ = stamp_of(source);
    looked_seconds_ = now_seconds;
    return false;
  }
  if (now_seconds - looked_seconds_ < period_seconds) return false;
  looked_seconds_ = now_seconds;
  const std::optional<Stamp> stamp = stamp_of(source);
  const bool still = stamp == seen_;
  seen_ = stamp;
  // A file that is gone, as while it is being replaced, is not worth a message.
  if (!stamp || !still || stamp == known_) return false;
  known_ = stamp;
  return true;
}

double FileWatch::seconds_to_look(double now_seconds) const {
  return std::max(0.0, looked_seconds_ + period_seconds - now_seconds);
}

}  // namespace asos
