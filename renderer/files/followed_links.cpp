#include "renderer/files/followed_links.h"

#include <system_error>

namespace asos {

std::filesystem::path followed_links(const std::filesystem::path& path) {
  constexpr int most_links = 40;  // as Linux follows
  std::filesystem::path at = path;
  std::error_code error;
  for (int i = 0; i < most_links; ++i) {
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(at, error))) return at;
    const std::filesystem::path target = std::filesystem::read_symlink(at, error);
    if (error) return at;
    at = at.parent_path() / target;  // an absolute target replaces everything
  }
  return path;
}

}  // namespace asos
