#pragma once

#include "asos/asos.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace asos::api::test {

/// An unlit white square of side `side` about (x, y, 0) that faces +Z.
inline Result<Scene> white_square(float x, float y, float side) {
  SceneBuilder builder("square");
  Material white{.unlit = true};
  const Result<int> material = builder.add_material(white);
  if (!material) return material.error();
  const float h = side / 2;
  const std::array<float, 12> positions{x - h, y - h, 0, x + h, y - h, 0,
                                        x + h, y + h, 0, x - h, y + h, 0};
  const std::array<std::uint32_t, 6> triangles{0, 1, 2, 0, 2, 3};
  MeshData mesh;
  mesh.name = "square";
  mesh.positions = positions;
  mesh.triangles = triangles;
  const Result<int> number = builder.add_mesh(mesh, *material);
  if (!number) return number.error();
  if (const Result<void> placed = builder.place_mesh(*number); !placed) return placed.error();
  return builder.build();
}

/// Looks along -Z at the square of x and y from -1 to 1.
inline Camera flat_camera() {
  Camera camera;
  camera.perspective = false;
  camera.height = 2.0;
  camera.world_from_camera = translation({0, 0, 5});
  return camera;
}

inline Light ball_lamp(float candela = 4000.0f) {
  Light lamp;
  lamp.name = "lamp";
  lamp.position = {1002, 3, 1};
  lamp.intensity = candela;
  return lamp;
}

/// A grey ball on a grey disk, far from the origin; lit by a lamp, or without a light of its own.
inline Result<Scene> lit_ball(bool lit = true) {
  SceneBuilder builder("ball");
  Material grey{.base_color = {0.5f, 0.5f, 0.5f, 1.0f}};
  const Result<int> material = builder.add_material(grey);
  if (!material) return material.error();
  Shape ball;
  Shape disk;
  disk.type = ShapeType::disk;
  disk.radius = 3.0;
  Result<void> done = builder.place_shape(ball, *material, translation({1000, 0.5, 0}), "ball");
  if (done) done = builder.place_shape(disk, *material, translation({1000, 0, 0}), "disk");
  if (done && lit) done = builder.add_light(ball_lamp());
  if (done) done = builder.add_camera(look_at({1002, 2, 4}, {1000, 0.4, 0}, 0.6));
  if (!done) return done.error();
  return builder.build();
}

/// The settings of a small picture in even light, without a ground.
inline Settings small_settings(int width, int height) {
  Settings settings;
  settings.width = width;
  settings.height = height;
  settings.max_level = 2;
  settings.threads = 2;
  settings.sky = "neutral";
  settings.ground = Ground::off;
  settings.background = Background::environment;
  return settings;
}

/// A file with one triangle that moves along x, from 0 to 4 m in 2 s.
inline std::string moving_triangle() {
  const std::vector<float> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 4, 0, 0};
  std::string bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
  std::string base64;
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int shift = 18; shift >= 0; shift -= 6) base64 += digits[group >> shift & 63u];
  }
  base64.resize((bytes.size() * 4 + 2) / 3);
  base64.resize((base64.size() + 3) / 4 * 4, '=');
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "animations":[{"name":"slide","samplers":[{"input":1,"output":2}],
      "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}],
    "accessors":[
      {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
      {"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[2]},
      {"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},
      {"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLength":24}],
    "buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,)" +
         base64 + "\"}]}";
}

}  // namespace asos::api::test
