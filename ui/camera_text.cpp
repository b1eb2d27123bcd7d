#include "ui/camera_text.h"

#include "renderer/gltf/export/gltf_writer.h"

#include <fmt/format.h>

#include <utility>

namespace asos::ui {

std::string camera_options(const Camera& camera, glm::dvec3 target, glm::dvec3 origin) {
  if (camera.type != Camera::Type::perspective) return {};
  const glm::dvec3 from = glm::dvec3(camera.world_from_camera[3]) + origin, to = target + origin;
  return fmt::format("--look-at {:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g} --fov {:.9g}", from.x,
                     from.y, from.z, to.x, to.y, to.z, glm::degrees(camera.fov_y_rad));
}

std::string camera_as_gltf(Camera camera, glm::dvec3 origin) {
  camera.world_from_camera[3] += glm::dvec4(origin, 0.0);
  Scene scene;
  scene.cameras.push_back(std::move(camera));
  exporting::GltfDocument document;
  exporting::write_cameras(scene, document);
  return document.root.dump(2) + "\n";
}

}  // namespace asos::ui
