#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace asos::test {

/// The folder with test models: $ASOS_SHARED, otherwise ../shared next to the sources; nullopt:
/// there is none, and the test must report that it is skipped.
inline std::optional<std::filesystem::path> shared_dir() {
  const char* set = std::getenv("ASOS_SHARED");
  const std::filesystem::path dir =
      set ? std::filesystem::path(set) : std::filesystem::path(ASOS_SOURCE_DIR) / ".." / "shared";
  if (!std::filesystem::is_directory(dir)) return std::nullopt;
  return std::filesystem::canonical(dir);
}

}  // namespace asos::test
