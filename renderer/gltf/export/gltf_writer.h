#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace asos::exporting {

/// A glTF document under construction: its JSON and its one binary buffer. Members that add
/// something return its index in the document.
class GltfDocument {
 public:
  /// Starts an empty document.
  GltfDocument();
  /// Starts from the JSON of a file, whose own buffer is the first one.
  explicit GltfDocument(nlohmann::json of_file);

  /// Appends bytes to the buffer, at a multiple of four. Returns their offset.
  std::size_t append(std::span<const std::uint8_t> bytes);
  /// Appends bytes as a buffer view that starts at a multiple of four. `target`: 34962 for vertex
  /// attributes, 34963 for indices, 0 for neither.
  int add_view(std::span<const std::uint8_t> bytes, int target);

  /// Adds an accessor over all of `values`, whose members are floats or 32-bit integers.
  template <typename T>
  int add_accessor(const std::vector<T>& values, const char* type, int component_type, int target) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
    return add("accessors", {{"bufferView", add_view({first, values.size() * sizeof(T)}, target)},
                             {"componentType", component_type},
                             {"count", values.size()},
                             {"type", type}});
  }

  /// Appends to one of the document's lists, such as "nodes".
  int add(const char* list, nlohmann::json value);
  /// Returns the default scene; without scenes, the root.
  [[nodiscard]] nlohmann::json& default_scene();
  /// Appends a node that is a root of the default scene. Without scenes, all nodes are shown.
  void add_root_node(nlohmann::json node);
  void use_extension(const std::string& name) { extensions_.insert(name); }

  nlohmann::json root;

  /// Writes the whole file, .glb or .gltf by its suffix. Errors: another suffix, too large for the
  /// container, cannot be written.
  [[nodiscard]] Result<void> write(const std::string& path);

 private:
  [[nodiscard]] Result<std::string> as_glb(const std::string& path);
  [[nodiscard]] std::string as_gltf();
  void finish();

  std::set<std::string> extensions_;
  std::vector<std::uint8_t> binary_;
};

/// Returns a new node, with its name if there is one.
[[nodiscard]] nlohmann::json named_node(const std::string& name);

/// Returns why `scene` cannot be written as glTF, naming the part; empty if it can.
[[nodiscard]] std::string why_not_exportable(const Scene& scene);

/// KHR_texture_transform's translation * rotation * scale for `uv_transform`. It is nullopt if the
/// matrix shears or projects, which the extension cannot express.
struct TextureTransform {
  glm::dvec2 offset{0.0};
  double rotation_rad = 0.0;  ///< counter-clockwise in the picture, with v pointing down
  glm::dvec2 scale{1.0};
};
[[nodiscard]] std::optional<TextureTransform> decompose(const glm::mat3& uv_transform);

/// Returns defocusing ratios as extras have them (MATERIALS.md).
[[nodiscard]] nlohmann::json dfr_json(const Dfr& dfr);

// Each function writes one kind of element; indices in the document are those in the scene.
[[nodiscard]] Result<void> write_images(const Scene& scene, const std::string& path,
                                        GltfDocument& document);
/// Writes one more image, with its alpha only if `alpha` is set.
[[nodiscard]] Result<int> write_image(const Image& image, bool alpha, const std::string& path,
                                      GltfDocument& document);
/// Must be called after write_images.
[[nodiscard]] Result<void> write_surroundings(const Scene& scene, const std::string& path,
                                              GltfDocument& document);
void write_materials(const Scene& scene, GltfDocument& document);
void write_meshes(const Scene& scene, GltfDocument& document);
void write_lights(const Scene& scene, GltfDocument& document);
/// Writes which lighting is added when the file is opened (LIGHTS.md).
void write_added_lighting(AddedLighting lighting, GltfDocument& document);
/// Writes the animations of a scene if writes_animations is true. The document's first nodes must
/// be those of write_meshes.
void write_animations(const Scene& scene, GltfDocument& document);
void write_cameras(const Scene& scene, GltfDocument& document);

/// Removes parts of the document's nodes: per node, the primitives of its mesh, or -1 for its
/// shape. The nodes and their children stay.
using NodeParts = std::map<std::size_t, std::set<int>>;
void remove_parts(const NodeParts& parts, nlohmann::json& root);

/// Writes `bytes` to a temporary file next to `path` and renames it to `path`, so that no
/// incomplete file is visible.
[[nodiscard]] Result<void> write_atomically(const std::string& path, const std::string& bytes);

}  // namespace asos::exporting
