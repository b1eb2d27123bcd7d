#pragma once

#include "renderer/scene/scene.h"
#include "tests/support/make_light.h"

#include <cmath>
#include <cstdint>

// Scenes to write to glTF.

namespace asos::test {

inline Mesh triangle_to_write() {
  return {.name = "triangle",
          .positions = {{0.1f, -2.0f, 1.0f / 3.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, -5.0f}},
          .normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
          .triangles = {{0, 1, 2}}};
}

/// A texture use with rotation, scale and offset.
inline TextureUse moved(int texture, double angle, glm::vec2 scale, glm::vec2 offset) {
  TextureUse use{.texture = texture, .texcoord = 1};
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  use.uv_transform = {glm::vec3(c * scale.x, -s * scale.x, 0.0f),
                      glm::vec3(s * scale.y, c * scale.y, 0.0f), glm::vec3(offset, 1.0f)};
  return use;
}

/// A scene that uses every exportable field.
inline Scene rich_scene() {
  Scene scene{.name = "rich \"\u00e9\u6f22\""};
  Image image{"checks", 3, 2, {}};
  for (int i = 0; i < 24; ++i) image.rgba.own().push_back(static_cast<std::uint8_t>(10 * i));
  scene.images = {image};
  scene.textures = {{"first", 0, Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest},
                    {"second", 0, Wrap::repeat, Wrap::repeat, Filter::linear}};

  Material full;
  full.name = "full";
  full.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
  full.base_color_texture = moved(0, 0.7, {2.0f, -3.0f}, {0.25f, -0.5f});
  full.metallic = 0.6f;
  full.roughness = 0.7f;
  full.metallic_roughness_texture.texture = 1;
  full.normal_texture.texture = 1;
  full.normal_texture.scale = 0.8f;
  full.occlusion_texture.texture = 0;
  full.occlusion_texture.scale = 0.7f;
  full.emissive = {0.5f, 0.25f, 1.0f};
  full.emissive_strength = 12.5f;
  full.emissive_texture.texture = 0;
  full.alpha_mode = AlphaMode::mask;
  full.alpha_cutoff = 0.3f;
  full.double_sided = true;
  full.ior = 1.33f;
  full.transmission = 0.9f;
  full.specular = 0.4f;
  full.specular_color = {1.0f, 0.5f, 2.0f};
  full.specular_texture.texture = 1;
  full.specular_color_texture = moved(0, 0.7, {2.0f, -3.0f}, {0.25f, -0.5f});
  full.transmission_texture.texture = 0;
  full.transmission_texture.texcoord = 1;
  full.coat.factor = 0.75f;
  full.coat.roughness = 0.3f;
  full.coat.texture.texture = 1;
  full.coat.roughness_texture = moved(1, 0.2, {2.0f, 3.0f}, {0.25f, -0.5f});
  full.coat.normal_texture.texture = 0;
  full.coat.normal_texture.scale = 0.6f;
  full.sheen.color = {0.9f, 0.1f, 0.3f};
  full.sheen.roughness = 0.4f;
  full.sheen.color_texture.texture = 0;
  full.sheen.roughness_texture.texture = 1;
  full.film.factor = 0.75f;
  full.film.ior = 1.4f;
  full.film.thickness_min_nm = 50.0f;
  full.film.thickness_max_nm = 350.0f;
  full.film.texture.texture = 1;
  full.film.thickness_texture.texture = 0;
  full.anisotropy.strength = 0.6f;
  full.anisotropy.rotation_rad = 1.57f;
  full.anisotropy.texture = moved(1, 0.3, {1.5f, 2.0f}, {0.5f, 0.25f});
  full.diffuse_transmission.factor = 0.7f;
  full.diffuse_transmission.color = {0.1f, 0.2f, 0.9f};
  full.diffuse_transmission.texture.texture = 1;
  full.diffuse_transmission.color_texture.texture = 0;
  full.volume.thickness = 0.3f;
  full.volume.thickness_texture.texture = 1;
  full.volume.attenuation_distance = 0.7f;
  full.volume.attenuation_color = {0.1f, 0.5f, 1.0f};
  full.volume.dispersion = 0.36f;
  full.dfr = Dfr{{{{0.1, 0.9, 2.0}, {0.2, 1.0 / 3.0, 2.5}, {0.0, 1.0, 32.0}}}, 0.125};
  Material flat;
  flat.name = "flat";
  flat.unlit = true;
  flat.alpha_mode = AlphaMode::blend;
  flat.dfr = Dfr{{{{0.05, 1.0, 64.0}, {0.05, 1.0, 64.0}, {0.05, 1.0, 64.0}}}, 0.0};
  scene.materials = {full, flat};

  Mesh mesh = triangle_to_write();
  mesh.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {0, 1, 0, 1}};
  mesh.texcoords[0] = {{0, 0}, {1, 0}, {0.3f, 1}};
  mesh.texcoords[1] = {{2, 0}, {1, -1}, {0.7f, 1}};
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 1}};
  mesh.material = 0;
  Mesh plain = triangle_to_write();
  plain.name = "plain";
  plain.material = 1;
  scene.meshes = {mesh, plain};
  glm::dmat4 mirrored(1.0);
  mirrored[0].x = -1.0 / 3.0;
  mirrored[3] = {1e6 + 0.123456789, 2.0, 3.0, 1.0};
  scene.instances = {{"a", 0, glm::dmat4(1.0)}, {"b", 1, mirrored}, {"c", 0, mirrored}};

  Light sun;
  sun.name = "sun";
  sun.type = Light::Type::directional;
  sun.direction = {0.0, 0.0, 1.0};  // opposite to glTF's own axis
  sun.intensity = 3.25f;
  Light spot;
  spot.name = "spot";
  spot.type = Light::Type::spot;
  spot.position = {1.5, -2.25, 1e5};
  spot.direction = glm::normalize(glm::dvec3(1, -2, 0.5));
  spot.color = {1.0f, 0.5f, 0.25f};
  spot.inner_cone_rad = 0.2;
  spot.outer_cone_rad = 0.6;
  spot.range = 40.0;
  Light point = make_bulb({0.1, 0.2, 0.3}, 80.0f);
  point.name = "point";
  point.casts_shadows = false;
  scene.lights = {sun, spot, point};

  Camera perspective;
  perspective.name = "perspective";
  perspective.world_from_camera[3] = {4.0, 5.0, 6.0, 1.0};
  perspective.fov_y_rad = 0.7;
  Camera flat_camera{.name = "orthographic",
                     .type = Camera::Type::orthographic,
                     .height = 7.0,
                     .aspect_ratio = 1.5};
  scene.cameras = {perspective, flat_camera};
  return scene;
}

}  // namespace asos::test
