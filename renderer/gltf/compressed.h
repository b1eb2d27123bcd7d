#pragma once

#include "renderer/gltf/document.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace draco {
class Mesh;
class PointAttribute;
}  // namespace draco

namespace asos::gltf {

class Accessors;

/// Returns the EXT_meshopt_compression (or KHR_) object of a buffer view, or null.
[[nodiscard]] const tinygltf::Value* meshopt_extension(const tinygltf::BufferView& view);

/// Decodes a buffer view. Faults: data that does not decode, and sizes that the compressed bytes
/// cannot have, before anything of that size is allocated.
[[nodiscard]] Checked<FileBytes> decode_meshopt(const tinygltf::Value& extension,
                                                const Accessors& accessors);

/// A primitive decoded from KHR_draco_mesh_compression.
class DracoPrimitive {
 public:
  /// Decodes a primitive by its `extension`. `index_count` is declared by the accessor of its
  /// indices. Faults: data that does not decode, or that claims more than was declared.
  [[nodiscard]] static Checked<DracoPrimitive> decode(const tinygltf::Value& extension,
                                                      Accessors& accessors,
                                                      std::uint64_t index_count);

  [[nodiscard]] bool has(const std::string& attribute) const;
  [[nodiscard]] std::size_t vertex_count() const;
  [[nodiscard]] std::vector<std::uint32_t> indices() const;
  [[nodiscard]] int components(const std::string& attribute) const;
  /// Returns one value per vertex; `normalized` is that of the attribute's accessor.
  [[nodiscard]] Checked<std::vector<float>> floats(const std::string& attribute, int components,
                                                   bool normalized) const;
  [[nodiscard]] Checked<std::vector<std::uint32_t>> integers(const std::string& attribute,
                                                             int components) const;

 private:
  std::shared_ptr<const draco::Mesh> mesh_;
  std::map<std::string, const draco::PointAttribute*> attributes_;
};

}  // namespace asos::gltf
