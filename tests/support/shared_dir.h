#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace asos::test {

/// The folder with models to test on: $ASOS_SHARED, else ../shared beside the sources; nullopt
/// where there is none, and the test has to say that it is skipped.
inline std::optional<std::filesystem::path> shared_dir() {
  const char* set = std::getenv("ASOS_SHARED");
  const std::filesystem::path dir =
      set ? std::filesystem::path(set) : std::filesystem::path(ASOS_SOURCE_DIR) / ".." / "shared";
  if (!std::filesystem::is_directory(dir)) return std::nullopt;
  return std::filesystem::canonical(dir);
}

}  // namespace asos::test
