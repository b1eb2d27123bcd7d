#include "renderer/gltf/lights_cameras.h"

#include "renderer/geometry/validate_camera.h"
#include "renderer/gltf/area_lights.h"
#include "renderer/gltf/camera_lens.h"
#include "renderer/gltf/light_values.h"
#include "renderer/gltf/validate_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace asos::gltf {

namespace {

using std::numbers::pi;

/// Returns the rotation and position of `m` without its scale; nullopt if a direction is lost.
std::optional<glm::dmat4> rigid(const glm::dmat4& m) {
  const glm::dvec3 back(m[2]), up(m[1]);
  if (!positive(glm::length(back)) || !positive(glm::length(up))) return std::nullopt;
  const glm::dvec3 z = glm::normalize(back);
  const glm::dvec3 across = glm::cross(glm::normalize(up), z);
  if (!(glm::length(across) > 1e-9)) return std::nullopt;
  const glm::dvec3 x = glm::normalize(across);
  return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                    m[3]);
}

/// Returns why the camera is invalid, or an empty string.
std::string read_projection(const tinygltf::Camera& source, Camera& camera) {
  if (source.type == "perspective") {
    const tinygltf::PerspectiveCamera& p = source.perspective;
    if (!positive(p.yfov) || p.yfov >= pi) return fmt::format("a field of view of {}", p.yfov);
    camera.type = Camera::Type::perspective;
    camera.fov_y_rad = p.yfov;
    if (positive(p.aspectRatio)) camera.aspect_ratio = p.aspectRatio;
    if (positive(p.znear)) camera.near_depth = p.znear;
    if (positive(p.zfar) && p.zfar > p.znear) camera.far_depth = p.zfar;
    return {};
  }
  if (source.type == "orthographic") {
    const tinygltf::OrthographicCamera& o = source.orthographic;
    if (!positive(std::abs(o.xmag)) || !positive(std::abs(o.ymag))) return "no extent";
    camera.type = Camera::Type::orthographic;
    camera.height = 2.0 * std::abs(o.ymag);
    camera.aspect_ratio = std::abs(o.xmag / o.ymag);
    if (o.znear >= 0.0 && std::isfinite(o.znear)) camera.near_depth = o.znear;
    if (positive(o.zfar) && o.zfar > o.znear) camera.far_depth = o.zfar;
    return {};
  }
  return fmt::format("the unknown type '{}'", source.type);
}

/// Returns why the light is invalid, or an empty string.
std::string read_light(const tinygltf::Light& source, const std::string& place, Light& light,
                       Warnings& warnings) {
  if (source.type == "point") {
    light.type = Light::Type::point;
  } else if (source.type == "spot") {
    light.type = Light::Type::spot;
  } else if (source.type == "directional") {
    light.type = Light::Type::directional;
  } else {
    return fmt::format("has the unknown type '{}'", source.type);
  }
  std::vector<double> color = source.color;
  if (color.size() != 3) {
    if (!color.empty()) warnings.add(place + ": its colour is not three numbers; white is used");
    color.assign(3, 1.0);
  }
  if (std::string why = set_brightness(source.intensity, color, light); !why.empty()) return why;
  if (positive(source.range)) light.range = source.range;  // 0 in tinygltf: infinite
  light.casts_shadows = on_or_off(source.extras, "casts_shadows").value_or(true);
  read_off_intensity(source.extras, light);
  if (light.type != Light::Type::spot) return {};

  light.inner_cone_rad = source.spot.innerConeAngle;
  light.outer_cone_rad = source.spot.outerConeAngle;
  const bool valid = light.inner_cone_rad >= 0.0 && light.inner_cone_rad < light.outer_cone_rad &&
                     light.outer_cone_rad <= 0.5 * pi + 1e-6;
  if (!valid) {
    warnings.add(fmt::format("{}: its cone angles {} and {} are not valid; brought into order",
                             place, light.inner_cone_rad, light.outer_cone_rad));
    if (!positive(light.outer_cone_rad)) light.outer_cone_rad = 0.25 * pi;
    if (!(light.inner_cone_rad >= 0.0)) light.inner_cone_rad = 0.0;
    light.outer_cone_rad = std::min(light.outer_cone_rad, 0.5 * pi);
    light.inner_cone_rad = std::min(light.inner_cone_rad, light.outer_cone_rad);
  }
  return {};
}

/// Returns a size from the node's extras or else the light's: 0 if neither has it, or, with a
/// warning, if it is not in [0, end).
double read_size(const tinygltf::Node& node, const tinygltf::Light& source, const std::string& name,
                 double end, const std::string& place, Warnings& warnings) {
  const tinygltf::Value& extras =
      node.extras.IsObject() && node.extras.Has(name) ? node.extras : source.extras;
  if (!extras.IsObject() || !extras.Has(name)) return 0.0;
  const std::optional<double> value = number(extras, name);
  if (value && *value >= 0.0 && *value < end) return *value;
  const std::string given = value ? fmt::format("of {}", *value) : "that is not a number";
  warnings.add(fmt::format("{} has a {} {}; it is taken to have no size", place, name, given));
  return 0.0;
}

/// Reads the size of a punctual light from extras, since glTF has no property for it (LIGHTS.md).
void read_sizes(const tinygltf::Node& node, const tinygltf::Light& source,
                const glm::dmat4& world_from_node, const std::string& place, Light& light,
                Warnings& warnings) {
  if (light.type == Light::Type::directional) {
    light.angular_diameter_rad = read_size(node, source, "angular_diameter", pi, place, warnings);
    return;
  }
  constexpr double largest = std::numeric_limits<float>::max();
  light.radius =
      largest_scale(world_from_node) * read_size(node, source, "radius", largest, place, warnings);
  if (light.radius <= largest) return;
  warnings.add(place + " is placed by a matrix that makes it endless; it is taken for a point");
  light.radius = 0.0;
}

void add_punctual_light(Document& document, const tinygltf::Node& node,
                        const glm::dmat4& world_from_node, Scene& scene) {
  const tinygltf::Value* reference = extension(node.extensions, "KHR_lights_punctual");
  if (!reference) return;
  const int index = whole(*reference, "light").value_or(-1);
  if (index < 0 || static_cast<std::size_t>(index) >= document.model.lights.size()) {
    document.warnings.add(fmt::format(
        "node '{}' has light {}, which the file does not define; left out", node.name, index));
    return;
  }
  const tinygltf::Light& source = document.model.lights[static_cast<std::size_t>(index)];
  const std::string& name = source.name.empty() ? node.name : source.name;
  const std::string place =
      name.empty() ? fmt::format("light {}", index) : fmt::format("light {} '{}'", index, name);
  Light light;
  if (const std::string why = read_light(source, place, light, document.warnings); !why.empty()) {
    document.warnings.add(fmt::format("{} {}; left out", place, why));
    return;
  }
  light.name = name;
  read_sizes(node, source, world_from_node, place, light, document.warnings);
  light.position = glm::dvec3(world_from_node[3]);
  const glm::dvec3 along = -glm::dvec3(world_from_node[2]);
  if (positive(glm::length(along))) {
    light.direction = glm::normalize(along);
  } else if (light.type != Light::Type::point) {
    document.warnings.add(place + " is placed by a matrix that leaves it no direction; left out");
    return;
  }
  if (const std::string why = validate_light(light); !why.empty()) {
    document.warnings.add(fmt::format("{} {}; left out", place, why));
    return;
  }
  scene.lights.push_back(std::move(light));
}

/// Reads a lens. Orthographic cameras have none, and invalid lenses are left out, with a warning.
void add_lens(const tinygltf::Camera& source, const std::string& place, Camera& camera,
              Warnings& warnings) {
  const Checked<Lens> lens = read_lens(source.extras, camera.fov_y_rad);
  if (!lens) {
    warnings.add(
        fmt::format("{}: the lens in its extras: {}; a pinhole is used", place, lens.error()));
  } else if (camera.type != Camera::Type::perspective && lens->blurs()) {
    warnings.add(place + " is orthographic: the lens in its extras is ignored");
  } else {
    camera.lens = *lens;
  }
}

}  // namespace

void add_camera(Document& document, const tinygltf::Node& node, const glm::dmat4& world_from_node,
                Scene& scene) {
  if (node.camera < 0) return;
  if (static_cast<std::size_t>(node.camera) >= document.model.cameras.size()) {
    document.warnings.add(fmt::format("camera {} does not exist; left out", node.camera));
    return;
  }
  if (document.broken_cameras.contains(static_cast<std::size_t>(node.camera))) return;
  const auto& source = document.model.cameras[static_cast<std::size_t>(node.camera)];
  const std::string place = fmt::format("camera {}", node.camera);
  Camera camera;
  camera.name = source.name.empty() ? node.name : source.name;
  if (const std::string why = read_projection(source, camera); !why.empty()) {
    document.warnings.add(fmt::format("{} has {}; left out", place, why));
    return;
  }
  add_lens(source, place, camera, document.warnings);
  const std::optional<glm::dmat4> placed = rigid(world_from_node);
  if (!placed) {
    document.warnings.add(place + " is placed by a matrix that squeezes it flat; left out");
    return;
  }
  camera.world_from_camera = *placed;
  if (const std::string why = validate_camera(camera); !why.empty()) {
    document.warnings.add(fmt::format("{}: {}; left out", place, why));
    return;
  }
  scene.cameras.push_back(std::move(camera));
}

void add_light(Document& document, const tinygltf::Node& node, const glm::dmat4& world_from_node,
               Scene& scene) {
  add_punctual_light(document, node, world_from_node, scene);
  add_area_light(document, node, world_from_node, scene);
}

AddedLighting added_lighting(Document& document, int scene) {
  constexpr const char* name = "asos_default_lighting";
  const tinygltf::Value& extras =
      scene < 0 ? document.model.extras
                : document.model.scenes[static_cast<std::size_t>(scene)].extras;
  if (!extras.IsObject() || !extras.Has(name)) return AddedLighting::automatic;
  const std::string value = text(extras, name);
  if (value == "none") return AddedLighting::none;
  if (value == "environment") return AddedLighting::environment;
  document.warnings.add(
      fmt::format("the scene's {} is neither 'none' nor 'environment'; ignored", name));
  return AddedLighting::automatic;
}

}  // namespace asos::gltf
