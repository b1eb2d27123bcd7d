#pragma once

#include "asos/asos.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace asos::api::test {

/// An unlit white square of side `side` about (x, y, 0) that faces +Z.
inline Result<Scene> white_square(float x, float y, float side) {
  SceneBuilder builder("square");
  Material white;
  white.unlit = true;
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
  Material grey;
  grey.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
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

}  // namespace asos::api::test
