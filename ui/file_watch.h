#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A file as it was at some moment.
struct FileStamp {
  // When it was written last, and its size: some systems' clocks are coarse.
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

/// Looks once a second whether files have changed since they were read. One thread.
class FileWatch {
 public:
  static constexpr double period_seconds = 1.0;

  /// Whether the files are not what they were when they were read, all of them are there that were,
  /// and all have been the same for a period: a program may still be writing.
  [[nodiscard]] bool changed(const std::vector<FileStamp>& read, double now_seconds);
  /// When to ask again, in seconds.
  [[nodiscard]] double seconds_to_look(double now_seconds) const;

 private:
  std::vector<FileStamp> seen_;  // in the last look
  std::optional<double> looked_seconds_;
};

}  // namespace asos::ui
