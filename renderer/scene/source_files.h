#pragma once

#include <string>
#include <vector>

namespace asos {

/// The files that a scene is read from, there or not: `source` itself first, then the buffers and
/// images that a glTF file names below its asset root (LoadOptions::asset_root). None for a
/// built-in scene; `source` alone where it cannot be read as glTF. Any thread.
[[nodiscard]] std::vector<std::string> source_files(const std::string& source,
                                                    const std::string& asset_root = {});

/// Whether a file at `path` can be one of them, told without reading the scene.
[[nodiscard]] bool may_be_source_file(const std::string& path, const std::string& source,
                                      const std::string& asset_root = {});

/// The lowest folder that holds the existing files that a glTF file names outside of its own
/// folder, where some of them lie outside of its asset root, too: an asset root from which all can
/// be read. Empty: there is no such file, or only the file system's root holds them all. Any
/// thread.
[[nodiscard]] std::string outer_asset_root(const std::string& source,
                                           const std::string& asset_root = {});

}  // namespace asos
