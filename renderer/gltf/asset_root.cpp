#include "renderer/gltf/asset_root.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <sys/stat.h>

namespace asos::gltf {

namespace fs = std::filesystem;

namespace {

constexpr int levels_above_model = 3;

bool is_below_or_same(const fs::path& path, const fs::path& folder) {
  const fs::path step = path.lexically_relative(folder);
  return !step.empty() && *step.begin() != "..";
}

/// Returns the device of a folder; nullopt if it is not readable.
std::optional<dev_t> device_of(const fs::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) return std::nullopt;
  return status.st_dev;
}

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  std::error_code error;
  return home && *home ? fs::weakly_canonical(home, error) : fs::path();
}

fs::path default_root(const fs::path& model) {
  const fs::path home = home_folder();
  const std::optional<dev_t> device = device_of(model);
  fs::path root = model;
  for (int level = 0; level < levels_above_model; ++level) {
    const fs::path parent = root.parent_path();
    const bool is_file_system = parent == parent.root_path();
    const bool holds_home = !home.empty() && is_below_or_same(home, parent);
    if (is_file_system || holds_home || !device || device_of(parent) != device) break;
    root = parent;
  }
  return root;
}

}  // namespace

bool AssetFolders::contain(const fs::path& path) const {
  return is_below_or_same(path, root) || is_below_or_same(path, model);
}

Checked<AssetFolders> asset_folders(const fs::path& folder, const fs::path& root) {
  std::error_code error;
  AssetFolders folders;
  folders.model = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return fault(fmt::format("the folder cannot be read ({})", error.message()));
  if (root.empty()) {
    folders.root = default_root(folders.model);
    return folders;
  }
  folders.root = fs::canonical(root, error);
  if (error)
    return fault(
        fmt::format("the asset root '{}' cannot be read ({})", root.string(), error.message()));
  if (!fs::is_directory(folders.root, error))
    return fault(fmt::format("the asset root '{}' is not a folder", root.string()));
  return folders;
}

}  // namespace asos::gltf
