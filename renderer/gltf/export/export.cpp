#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/load.h"

#include <algorithm>
#include <cctype>

namespace asos {

namespace {

bool ends_with(const std::string& path, const std::string& ending) {
  if (path.size() < ending.size()) return false;
  return std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char e, char p) {
    return e == static_cast<char>(std::tolower(static_cast<unsigned char>(p)));
  });
}

}  // namespace

Result<void> export_gltf(const Scene& scene, const std::string& path) {
  // Check everything before writing.
  const bool binary = ends_with(path, ".glb");
  if (!binary && !ends_with(path, ".gltf")) {
    return unexpected(Error{path, "a scene is written as .glb or .gltf"});
  }
  if (const std::string why = exporting::why_not_exportable(scene); !why.empty()) {
    return unexpected(Error{path, why});
  }

  // Collect the document, then write it as a whole.
  exporting::GltfDocument document;
  if (!scene.name.empty()) document.root["scenes"][0]["name"] = scene.name;
  if (Result<void> images = exporting::write_images(scene, path, document); !images) {
    return images;
  }
  if (Result<void> written = exporting::write_surroundings(scene, path, document); !written) {
    return written;
  }
  exporting::write_materials(scene, document);
  exporting::write_meshes(scene, document);
  if (writes_animations(scene)) exporting::write_animations(scene, document);
  exporting::write_lights(scene, document);
  exporting::write_added_lighting(scene.added_lighting, document);
  exporting::write_cameras(scene, document);
  return document.write(path);
}

}  // namespace asos
