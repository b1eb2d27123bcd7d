#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asos {

using FileBytes = std::vector<std::uint8_t>;

/// The beginning of a file, at most `length` bytes of it, and how much there is of it in all.
struct FileHead {
  static constexpr std::size_t length = 64;

  std::span<const std::uint8_t> bytes;
  std::uint64_t file_size = 0;
};

/// What a file has to be to be read.
struct FileRules {
  std::uint64_t most_bytes = 0;
  /// Why the file cannot be what is wanted, told from its beginning before the rest is read, so
  /// that gigabytes of something else cost nothing; empty: it may be. Without one, all may be.
  std::function<std::string(const FileHead& head)> fault{};
};

/// A regular file's contents; the one way by which the program reads what it is given. Directories,
/// pipes, devices and what breaks the rules are refused without waiting; the reason is the error.
[[nodiscard]] tl::expected<FileBytes, std::string> read_file(const std::filesystem::path& path,
                                                             const FileRules& rules);

/// Whether `bytes` begin with `magic`.
[[nodiscard]] bool begins_with(std::span<const std::uint8_t> bytes, std::string_view magic);

}  // namespace asos
