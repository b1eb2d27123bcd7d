#include "renderer/picture/exr_picture.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace asos {
namespace {

// OpenEXR's camera space is left-handed, +z ahead; ours looks along -z.
glm::dmat4 world_to_camera(const Camera& camera, glm::dvec3 origin) {
  glm::dmat4 placed = camera.world_from_camera;
  placed[3] += glm::dvec4(origin, 0.0);
  glm::dmat4 ahead(1.0);
  ahead[2][2] = -1.0;
  return ahead * glm::inverse(placed);
}

// From camera space to 0..1 over the whole picture, y down.
glm::dmat4 camera_to_ndc(const Camera& camera, const RenderSettings& settings) {
  const bool perspective = camera.type == Camera::Type::perspective;
  const double height = perspective ? 2.0 * std::tan(0.5 * camera.fov_y_rad) : camera.height;
  const double width = height * settings.width / settings.height;
  const int shift = perspective ? 2 : 3;  // the column that is multiplied by z, or by 1
  glm::dmat4 ndc(0.0);
  ndc[0][0] = 1.0 / width;
  ndc[1][1] = -1.0 / height;
  ndc[2][2] = 1.0;
  ndc[shift][0] = ndc[shift][1] = 0.5;
  ndc[shift][3] = 1.0;
  return ndc;
}

// Returns the asset of an object: the top-level node that it belongs to, or else the object itself.
// The ground belongs to no node.
std::string asset_of(const Part& part, const std::vector<SceneContents::Node>& nodes) {
  auto node = static_cast<std::size_t>(part.node);
  if (part.node < 0 || node >= nodes.size()) return part.name;
  while (nodes[node].parent >= 0) node = static_cast<std::size_t>(nodes[node].parent);
  return nodes[node].name.empty() ? fmt::format("node {}", node + 1) : nodes[node].name;
}

}  // namespace

ExrOptions exr_options(const RenderScene& scene, const Camera& camera,
                       const RenderSettings& settings) {
  ExrOptions options;
  options.layers = settings.layers;
  const PixelRect visible = settings.visible();
  options.window = {settings.width, settings.height, visible.x, visible.y};
  options.world_to_camera = world_to_camera(camera, scene.world().origin);
  options.world_to_ndc = camera_to_ndc(camera, settings) * *options.world_to_camera;
  if (!settings.layers.has_ids()) return options;
  for (const Part& part : scene.world().parts) {
    options.object_names.push_back(part.name);
    options.asset_names.push_back(asset_of(part, scene.geometry->contents.nodes));
  }
  for (const Material& material : scene.world().materials)
    options.material_names.push_back(material.name);
  return options;
}

}  // namespace asos
