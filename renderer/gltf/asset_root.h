#pragma once

#include "renderer/gltf/warnings.h"

#include <filesystem>

namespace asos::gltf {

/// The folders from which a model's files may come; both are canonical.
struct AssetFolders {
  std::filesystem::path model;  ///< the model file's folder; URIs are relative to it
  std::filesystem::path root;   ///< files inside it, at any depth, may be read

  /// Returns whether `path`, which is canonical, is inside one of the folders.
  [[nodiscard]] bool contain(const std::filesystem::path& path) const;
};

/// Returns the folders of the model in `folder`. An empty `root` selects the default root: the
/// highest folder at most three levels above the model's, but never the file system's root, the
/// home folder, one above that, or one on another device. Faults: a folder that does not exist.
[[nodiscard]] Checked<AssetFolders> asset_folders(const std::filesystem::path& folder,
                                                  const std::filesystem::path& root);

}  // namespace asos::gltf
