#include "renderer/scene/builtin/scene_assembler.h"

#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/make_light.h"
#include "renderer/scene/tessellate.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace asos::builtin {

namespace {

glm::vec3 linear_from_srgb(std::uint32_t srgb) {
  const auto channel = [srgb](int shift) {
    const double s = ((srgb >> shift) & 0xffu) / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  };
  return {channel(16), channel(8), channel(0)};
}

}  // namespace

SceneAssembler::SceneAssembler(const std::string& name) {
  scene_.name = name;
  scene_.source = "builtin:" + name;
}

int SceneAssembler::paint(const std::string& name, std::uint32_t srgb, float roughness,
                          float metallic) {
  Material material;
  material.name = name;
  material.base_color = glm::vec4(linear_from_srgb(srgb), 1.0f);
  material.roughness = roughness;
  material.metallic = metallic;
  scene_.materials.push_back(material);
  return static_cast<int>(scene_.materials.size()) - 1;
}

int SceneAssembler::glow(const std::string& name, std::uint32_t srgb, float nits) {
  const int index = paint(name, 0x000000, 1.0f);
  scene_.materials[index].emissive = linear_from_srgb(srgb);
  scene_.materials[index].emissive_strength = nits;
  return index;
}

Material& SceneAssembler::material(std::string_view name) {
  const auto found = std::find_if(scene_.materials.begin(), scene_.materials.end(),
                                  [name](const Material& m) { return m.name == name; });
  assert(found != scene_.materials.end());
  return *found;
}

int SceneAssembler::keep_texture(Image image, Wrap wrap) {
  Texture texture;
  texture.name = image.name;
  texture.wrap_u = texture.wrap_v = wrap;
  texture.image = static_cast<int>(scene_.images.size());
  scene_.images.push_back(std::move(image));
  scene_.textures.push_back(texture);
  return static_cast<int>(scene_.textures.size()) - 1;
}

void SceneAssembler::cover(std::string_view name, int texture, float metres) {
  Material& covered = material(name);
  covered.base_color = glm::vec4(1.0f);
  covered.base_color_texture = by_metres(texture, metres);
  for (Mesh& mesh : scene_.meshes) {
    if (&scene_.materials[mesh.material] == &covered) add_texcoords(mesh);
  }
}

int SceneAssembler::keep(const std::string& name, Mesh mesh, int material) {
  mesh.name = name;
  mesh.material = material;
  scene_.meshes.push_back(std::move(mesh));
  return static_cast<int>(scene_.meshes.size()) - 1;
}

void SceneAssembler::place(const std::string& name, int mesh, const glm::dmat4& world_from_mesh) {
  scene_.instances.push_back({name, mesh, world_from_mesh});
}

void SceneAssembler::add(const std::string& name, Mesh mesh, int material) {
  place(name, keep(name, std::move(mesh), material), glm::dmat4(1.0));
}

void SceneAssembler::add(const std::string& name, const Shape& shape,
                         const glm::dmat4& world_from_shape, int material) {
  place(name, keep(name, tessellated(shape), material), world_from_shape);
  scene_.instances.back().shape = static_cast<int>(scene_.shapes.size());
  scene_.shapes.push_back(shape);
}

void SceneAssembler::sun(const std::string& name, glm::dvec3 travel, std::uint32_t srgb, float lux,
                         double diameter_rad) {
  add_light(make_sun(glm::normalize(travel), lux, diameter_rad), name, srgb);
}

void SceneAssembler::add_light(Light light, const std::string& name, std::uint32_t srgb) {
  light.name = name;
  light.color = linear_from_srgb(srgb);
  scene_.lights.push_back(std::move(light));
}

void SceneAssembler::lamp(const std::string& name, glm::dvec3 position, std::uint32_t srgb,
                          float candela) {
  ball(name, position, 0.0, srgb, candela);
}

void SceneAssembler::spot(const std::string& name, glm::dvec3 position, glm::dvec3 target,
                          std::uint32_t srgb, float candela, double outer_cone_deg) {
  const double outer_cone_rad = glm::radians(outer_cone_deg);
  add_light(make_spot(position, glm::normalize(target - position), outer_cone_rad,
                      0.6 * outer_cone_rad, candela),
            name, srgb);
}

void SceneAssembler::ball(const std::string& name, glm::dvec3 position, double radius,
                          std::uint32_t srgb, float candela) {
  add_light(make_bulb(position, candela, radius), name, srgb);
}

void SceneAssembler::tube(const std::string& name, glm::dvec3 from, glm::dvec3 to,
                          std::uint32_t srgb, float candela) {
  add_light(make_tube(0.5 * (from + to), 0.5 * (to - from), candela), name, srgb);
}

void SceneAssembler::panel(const std::string& name, glm::dvec3 centre, glm::dvec3 target,
                           glm::dvec2 size, std::uint32_t srgb, float nits) {
  const glm::dvec3 direction = glm::normalize(target - centre);
  const glm::dvec3 level = glm::cross(direction, glm::dvec3(0, 1, 0));
  const glm::dvec3 u = glm::length(level) > 1e-9 ? glm::normalize(level) : glm::dvec3(1, 0, 0);
  add_light(make_panel(centre, direction, 0.5 * size.x * u, 0.5 * size.y * glm::cross(u, direction),
                       nits),
            name, srgb);
}

void SceneAssembler::soft_sun(const std::string& name, glm::dvec3 target, glm::dvec3 travel,
                              double distance, std::uint32_t srgb, float lux) {
  const glm::dvec2 size(0.3 * distance);
  const double nits = static_cast<double>(lux) / illuminance_before(size, distance);
  panel(name, target - distance * glm::normalize(travel), target, size, srgb,
        static_cast<float>(nits));
}

void SceneAssembler::cast_no_shadows() {
  for (Light& light : scene_.lights) light.casts_shadows = false;
}

void SceneAssembler::camera(const std::string& name, glm::dvec3 eye, glm::dvec3 target,
                            double fov_y_deg) {
  Camera camera;
  camera.name = name;
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
  camera.fov_y_rad = glm::radians(fov_y_deg);
  scene_.cameras.push_back(camera);
}

double illuminance_before(glm::dvec2 size, double distance) {
  const glm::dvec2 half = 0.5 * size / distance;
  const glm::dvec2 reach = glm::sqrt(1.0 + half * half);
  return 2.0 * (half.x / reach.x * std::atan(half.y / reach.x) +
                half.y / reach.y * std::atan(half.x / reach.y));
}

TextureUse by_metres(int texture, float metres) {
  TextureUse use;
  use.texture = texture;
  use.uv_transform = glm::mat3(1.0f / metres);
  use.uv_transform[2][2] = 1.0f;
  return use;
}

glm::dmat4 turned(glm::dvec3 position, double degrees) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), position), glm::radians(degrees),
                     glm::dvec3(0, 1, 0));
}

}  // namespace asos::builtin
