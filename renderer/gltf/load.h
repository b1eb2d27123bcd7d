#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <string>

namespace asos {

struct LoadOptions {
  /// Refused above this, before anything of that size is allocated.
  std::uint64_t max_triangles = 60'000'000;
  bool keep_rig = false;     ///< Scene::rig is set where there are animations
  std::string variant = {};  ///< of the file's materials (KHR_materials_variants); empty: none
  std::string scene = {};  ///< of the file's, by its number from 0 or its name; empty: its default
  /// Folder that buffers and images may come from, however far below; empty: at most three levels
  /// above the file (see gltf::asset_folders).
  std::string asset_root = {};
};

/// Opens "builtin:NAME" or the path of a .gltf or .glb file. The error names the file and the
/// reason. Any thread.
[[nodiscard]] Result<Scene> load_scene(const std::string& source, const LoadOptions& options = {});

/// glTF 2.0 through tinygltf, validated after it; see renderer/gltf/.
[[nodiscard]] Result<Scene> import_gltf(const std::string& path, const LoadOptions& options = {});

/// Writes `scene` as a self-contained .glb (or .gltf with embedded buffers, by the ending).
[[nodiscard]] Result<void> export_gltf(const Scene& scene, const std::string& path);

}  // namespace asos
