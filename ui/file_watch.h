#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asos {

/// Looks once a second whether a file has changed. One thread.
class FileWatch {
 public:
  static constexpr double period_seconds = 1.0;

  /// True once for each change of the file `source`, as soon as it has been the same for a period:
  /// a program may still be writing. Another source starts anew; one that is no file never changes.
  [[nodiscard]] bool changed(const std::string& source, double now_seconds);
  /// When to ask again, in seconds.
  [[nodiscard]] double seconds_to_look(double now_seconds) const;

 private:
  // When it was written last, and its size: some systems' clocks are coarse.
  struct Stamp {
    std::filesystem::file_time_type written;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  [[nodiscard]] static std::optional<Stamp> stamp_of(const std::string& source);

  std::string source_;
  std::optional<Stamp> known_;  // what was told
  std::optional<Stamp> seen_;   // in the last look
  double looked_seconds_ = 0.0;
};

}  // namespace asos
