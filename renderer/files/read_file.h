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

/// The first bytes of a file, at most `length`, and the file's total size.
struct FileHead {
  static constexpr std::size_t length = 64;

  std::span<const std::uint8_t> bytes;
  std::uint64_t file_size = 0;
};

/// The requirements for a file to be read.
struct FileRules {
  std::uint64_t most_bytes = 0;
  /// Returns why the file is refused, from its first bytes, before the rest is read. Large files of
  /// another kind are thus rejected at once. Empty: it may be read. Without a function, all files
  /// may be read.
  std::function<std::string(const FileHead& head)> fault{};
};

/// Reads a regular file's contents; the program reads all its input files with it. Directories,
/// pipes, devices, and files that violate the rules are refused immediately, with the reason as the
/// error.
[[nodiscard]] tl::expected<FileBytes, std::string> read_file(const std::filesystem::path& path,
                                                             const FileRules& rules);

/// Returns whether `bytes` begin with `magic`.
[[nodiscard]] bool begins_with(std::span<const std::uint8_t> bytes, std::string_view magic);

}  // namespace asos
