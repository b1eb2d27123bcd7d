#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/stage.h"

namespace asos::builtin {

namespace {

/// The lamp's place, its colour and its candela, whatever its shape.
constexpr glm::dvec3 lamp_place(-2.6, 7.5, 3.4);
constexpr std::uint32_t lamp_srgb = 0xfff4e2;
constexpr float lamp_candela = 185.0f;

// The shapes of GI'93 figure 6 with their shadows: sphere, cylinder, cone, truncated cone, box and
// disk over a plane. Round ones have 256 sides, so that their outlines look smooth up close. All
// but the main light.
void furnish(Stage& stage) {
  constexpr int sides = 256;

  Mesh plane;
  add_quad(plane, {-300, 0, 300}, {300, 0, 300}, {300, 0, -300}, {-300, 0, -300});
  stage.add("plane", std::move(plane), stage.paint("plane", 0xd9d4c8, 0.9f));

  Mesh sphere;
  add_sphere(sphere, {-2.35f, 0.95f, -0.45f}, 0.8f, 64);
  stage.add("sphere", std::move(sphere), stage.paint("red", 0xc8402f, 0.35f));

  Mesh cylinder;
  add_frustum(cylinder, {-0.85f, 0.0f, -1.5f}, {-0.85f, 1.9f, -1.5f}, 0.55f, 0.55f, sides);
  stage.add("cylinder", std::move(cylinder), stage.paint("blue", 0x3f6fb5, 0.5f));

  Mesh cone;
  add_frustum(cone, {0.95f, 0.0f, -1.35f}, {0.95f, 2.1f, -1.35f}, 0.75f, 0.0f, sides);
  stage.add("cone", std::move(cone), stage.paint("yellow", 0xe0b03a, 0.6f));

  Mesh truncated;
  add_frustum(truncated, {2.45f, 0.0f, -0.5f}, {2.45f, 1.15f, -0.5f}, 0.75f, 0.35f, sides);
  stage.add("truncated cone", std::move(truncated), stage.paint("green", 0x4c9a5a, 0.6f));

  Mesh box;
  add_box(box, glm::vec3(-0.6f, -0.45f, -0.4f), glm::vec3(0.6f, 0.45f, 0.4f));
  const int box_mesh = stage.keep("box", std::move(box), stage.paint("violet", 0x7d5ba6, 0.7f));
  stage.place("box", box_mesh, turned({-0.75, 0.45, 0.75}, 28.0));

  Mesh disk;  // tilted, above the plane: its shadow is an ellipse that touches nothing
  add_disk(disk, {0.85f, 0.5f, 1.2f}, glm::normalize(glm::vec3(-0.3f, 1.0f, 0.35f)), 0.6f, sides);
  const int disk_paint = stage.paint("orange", 0xe07b39, 0.6f);
  stage.make_double_sided(disk_paint);
  stage.add("disk", std::move(disk), disk_paint);

  stage.sun("sky", {0.3, -1.0, 0.2}, 0xd5e2ff, 0.7f);
  stage.sun("fill", {-0.03, -0.06, -1.0}, 0xdfe9ff, 0.6f);
  stage.camera("front", {0.25, 3.5, 7.0}, {0.05, 0.72, -0.3}, 34.0);
  stage.camera("low", {-3.6, 0.9, 4.6}, {0.1, 0.75, -0.5}, 42.0);
}

}  // namespace

Scene make_primitives() {
  Stage stage("primitives");
  stage.lamp("lamp", lamp_place, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

// The lights of figure 6 have about a quarter of their distance in size, and all give the same
// light where the shapes stand.

Scene make_primitives_ball() {
  Stage stage("primitives-ball");
  stage.ball("ball", lamp_place, 1.0, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

Scene make_primitives_linear() {
  Stage stage("primitives-linear");
  const glm::dvec3 half(1.25, 0.0, 0.0);
  stage.tube("tube", lamp_place - half, lamp_place + half, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

Scene make_primitives_rectangle() {
  Stage stage("primitives-rectangle");
  // It hangs level; seen from the origin, its outline shrinks by a cosine, which the nits make up.
  constexpr double side = 2.0;
  const double cosine = lamp_place.y / glm::length(lamp_place);
  const double nits = static_cast<double>(lamp_candela) / (side * side * cosine);
  stage.panel("panel", lamp_place, lamp_place - glm::dvec3(0, 1, 0), {side, side}, lamp_srgb,
              static_cast<float>(nits));
  furnish(stage);
  return stage.take();
}

}  // namespace asos::builtin
