#pragma once

#include "renderer/gltf/files.h"
#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace asos::gltf {

using Bytes = std::span<const std::uint8_t>;

/// An image as the file declares it; nothing is decoded yet.
struct ImageSource {
  std::string name;
  std::string uri;  ///< empty where the image lies in a buffer view
  int buffer_view = -1;
};

/// A buffer's bytes, or why there are none. Only a use of the buffer makes that an error.
struct Buffer {
  std::shared_ptr<const FileBytes> held;  ///< buffers of one file share it
  Bytes bytes;
  std::string missing_because;  ///< empty where the bytes are there
};

/// A glTF file taken apart. `model` is tinygltf's reading of the JSON alone: it has no buffers and
/// no images, and a primitive's indices are the attribute `indices_attribute`. Nothing in it is
/// known to be in range.
struct Document {
  static constexpr const char* indices_attribute = "/indices";

  ModelFiles files;
  tinygltf::Model model;
  std::vector<ImageSource> images;
  std::vector<Buffer> buffers;
  /// By buffer view: bytes between the beginnings of its elements; 0: they are packed. tinygltf
  /// refuses files for what glTF does not allow, however readable.
  std::vector<std::uint64_t> strides;
  std::set<std::size_t> broken_cameras;  ///< their numbers
  std::vector<std::string> unsupported_extensions;
  std::vector<std::string> variants;  ///< names by KHR_materials_variants
  /// `movable_parts` where an animation moves materials, lights or cameras; null: none does.
  std::shared_ptr<const nlohmann::json> movable;
  /// Bytes of the file and of all that it brought along: bounds what an import may allocate.
  std::uint64_t honest_bytes = 0;
  Warnings warnings;
};

/// Reads a .gltf or .glb file and the buffers that it names. Faults: not a glTF 2.0 file, JSON that
/// is broken or nested too deeply, a required extension that is not supported, an asset root that
/// is no folder. `asset_root`: see asset_folders.
[[nodiscard]] Checked<Document> read_document(const std::filesystem::path& path,
                                              const std::filesystem::path& asset_root = {});

}  // namespace asos::gltf
