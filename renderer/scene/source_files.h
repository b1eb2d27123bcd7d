#pragma once

#include <string>
#include <vector>

namespace asos {

/// Returns the files that a scene is read from, whether they exist or not: `source` itself first,
/// then the buffers and images that a glTF file names below its asset root
/// (LoadOptions::asset_root), or the files beside a model in another format whose names occur in
/// it. None for a built-in scene; only `source` if it is not readable as
/// glTF. Any thread.
[[nodiscard]] std::vector<std::string> source_files(const std::string& source,
                                                    const std::string& asset_root = {});

/// Returns whether a file at `path` can be one of source_files, without reading the scene.
[[nodiscard]] bool may_be_source_file(const std::string& path, const std::string& source,
                                      const std::string& asset_root = {});

/// Returns an asset root from which all files of a scene can be read: the lowest folder that
/// contains the existing files that a glTF file names outside of its own folder. Empty if none of
/// them lies outside of the present asset root, or only the root of the file system contains them
/// all. Any thread.
[[nodiscard]] std::string outer_asset_root(const std::string& source,
                                           const std::string& asset_root = {});

}  // namespace asos
