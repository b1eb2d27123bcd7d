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
  std::string uri;  ///< empty if the image is in a buffer view
  int buffer_view = -1;
};

/// A buffer's bytes, or the reason why there are none. The reason becomes an error only if the
/// buffer is used.
struct Buffer {
  std::shared_ptr<const FileBytes> held;  ///< buffers of one file share it
  Bytes bytes;
  std::string missing_because;  ///< empty if the bytes are there
};

/// The parts of a glTF file. `model` is tinygltf's reading of the JSON alone: it has no buffers and
/// no images, and a primitive's indices are the attribute `indices_attribute`. Nothing in it has
/// been range-checked.
struct Document {
  static constexpr const char* indices_attribute = "/indices";

  ModelFiles files;
  tinygltf::Model model;
  std::vector<ImageSource> images;
  std::vector<Buffer> buffers;
  /// Bytes between the starts of elements, indexed by buffer view; 0: packed. They are kept
  /// here, since tinygltf rejects files with strides that glTF does not allow, even if they are
  /// readable.
  std::vector<std::uint64_t> strides;
  std::set<std::size_t> broken_cameras;  ///< indices of the cameras with faults
  std::vector<std::string> unsupported_extensions;
  std::vector<std::string> variants;  ///< names by KHR_materials_variants
  /// `movable_parts` if an animation moves materials, lights or cameras; else null.
  std::shared_ptr<const nlohmann::json> movable;
  /// Bytes of the file and of all files that it names; it limits the memory that an import may
  /// allocate.
  std::uint64_t honest_bytes = 0;
  Warnings warnings;
};

/// Reads a .gltf or .glb file and the buffers that it names. Faults: not a glTF 2.0 file, JSON that
/// is broken or nested too deeply, a required extension that is not supported, an asset root that
/// is no folder. `asset_root`: see asset_folders.
[[nodiscard]] Checked<Document> read_document(const std::filesystem::path& path,
                                              const std::filesystem::path& asset_root = {});

/// Returns the scene that a file selects, or else its first; -1 if it has none. Irregularities
/// become warnings of the document.
[[nodiscard]] int default_scene(Document& document);

/// Returns the scene with this number, from 0, or else the first with this name. The fault lists
/// the existing scenes.
[[nodiscard]] Checked<int> find_scene(const Document& document, const std::string& wanted);

}  // namespace asos::gltf
