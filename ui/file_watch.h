#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A file's state at one moment.
struct FileStamp {
  // Time of the last write, and size, because some file systems' clocks are coarse.
  struct State {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;
    bool operator==(const State&) const = default;
  };
  std::string path;
  std::optional<State> state;  ///< none: it was not there

  [[nodiscard]] static FileStamp of(const std::string& path);
  bool operator==(const FileStamp&) const = default;
};

/// Checks once a second whether files have changed since they were read. Not thread-safe.
class FileWatch {
 public:
  static constexpr double period_seconds = 1.0;

  /// Returns true if files differ from when they were read, none has vanished, and all have been
  /// unchanged for one period (a program may still be writing).
  [[nodiscard]] bool changed(const std::vector<FileStamp>& read, double now_seconds);
  /// Seconds until the next check is due.
  [[nodiscard]] double seconds_to_look(double now_seconds) const;

 private:
  std::vector<FileStamp> seen_;  // in the last look
  std::optional<double> looked_seconds_;
};

}  // namespace asos::ui
