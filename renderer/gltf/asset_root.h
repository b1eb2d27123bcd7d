#pragma once

#include "renderer/gltf/warnings.h"

#include <filesystem>

namespace asos::gltf {

/// Folders that a model's files may come from; both are canonical.
struct AssetFolders {
  std::filesystem::path model;  ///< the model file's own; URIs are relative to it
  std::filesystem::path root;   ///< files in it or below it may be read

  /// Whether `path`, which is canonical, lies in one of the folders or below.
  [[nodiscard]] bool contain(const std::filesystem::path& path) const;
};

/// The folders of the model in `folder`. An empty `root` is the default root: the highest folder at
/// most three levels above the model's, but never the file system's root, the home folder, one
/// above that, or one on another device. Faults: a folder that does not exist.
[[nodiscard]] Checked<AssetFolders> asset_folders(const std::filesystem::path& folder,
                                                  const std::filesystem::path& root);

}  // namespace asos::gltf
