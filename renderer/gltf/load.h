#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <string>

namespace asos {

struct LoadOptions {
  /// Files with more are rejected, before anything of that size is allocated.
  std::uint64_t max_triangles = 60'000'000;
  bool keep_posable = false;  ///< set Scene::rig if there are animations
  /// One of the file's material variants (KHR_materials_variants); empty: none.
  std::string variant = {};
  /// One of the file's scenes, by number from 0 or name; empty: its default.
  std::string scene = {};
  /// Folder from which buffers and images may come, at any depth; empty: at most three levels above
  /// the file (see gltf::asset_folders).
  std::string asset_root = {};
  /// Read materials, textures and images only: the scene has no meshes, lights or cameras.
  bool images_only = false;
};

/// Opens "builtin:NAME", the path of a .gltf or .glb file, or that of a model that assimp converts
/// (converted.h). The error has the file's name and the
/// reason. Any thread.
[[nodiscard]] Result<Scene> load_scene(const std::string& source, const LoadOptions& options = {});

/// Imports glTF 2.0 through tinygltf, with additional validation; see renderer/gltf/.
[[nodiscard]] Result<Scene> import_gltf(const std::string& path, const LoadOptions& options = {});

/// Returns whether export_gltf writes the scene's animations. They must move whole objects, and the
/// scene must have its rig.
[[nodiscard]] bool writes_animations(const Scene& scene);

/// Writes `scene` as a self-contained .glb (or .gltf with embedded buffers, by the suffix).
[[nodiscard]] Result<void> export_gltf(const Scene& scene, const std::string& path);

}  // namespace asos
