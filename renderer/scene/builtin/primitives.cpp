#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace asos::builtin {

namespace {

/// The lamp's position, colour and candela, for all of its shapes.
constexpr glm::dvec3 lamp_place(-2.6, 7.5, 3.4);
constexpr std::uint32_t lamp_srgb = 0xfff4e2;
constexpr float lamp_candela = 185.0f;

Shape round(Shape::Type type, double radius) {
  Shape shape;
  shape.type = type;
  shape.radius = radius;
  return shape;
}

Shape cone(double height, double radius_bottom, double radius_top) {
  Shape shape;
  shape.type = Shape::Type::cylinder;
  shape.height = height;
  shape.radius_bottom = radius_bottom;
  shape.radius_top = radius_top;
  return shape;
}

glm::dmat4 moved(glm::dvec3 to) {
  return glm::translate(glm::dmat4(1.0), to);
}

// Returns the rotation from +Y to `up`, followed by the move to `position`.
glm::dmat4 facing(glm::dvec3 position, glm::dvec3 up) {
  const glm::dvec3 y = glm::normalize(up), z = glm::normalize(glm::cross(glm::dvec3(1, 0, 0), y));
  return {glm::dvec4(glm::cross(y, z), 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0),
          glm::dvec4(position, 1.0)};
}

// Adds the shapes of GI'93 figure 6 with their shadows: sphere, cylinder, cone, truncated cone, box
// and disk over a plane. Adds all but the main light.
void furnish(SceneAssembler& stage) {
  Mesh plane;
  add_quad(plane, {-300, 0, 300}, {300, 0, 300}, {300, 0, -300}, {-300, 0, -300});
  stage.add("plane", std::move(plane), stage.paint("plane", 0xd9d4c8, 0.9f));

  stage.add("sphere", round(Shape::Type::sphere, 0.8), moved({-2.35, 0.95, -0.45}),
            stage.paint("red", 0xc8402f, 0.35f));
  stage.add("cylinder", cone(1.9, 0.55, 0.55), moved({-0.85, 0.95, -1.5}),
            stage.paint("blue", 0x3f6fb5, 0.5f));
  stage.add("cone", cone(2.1, 0.75, 0.0), moved({0.95, 1.05, -1.35}),
            stage.paint("yellow", 0xe0b03a, 0.6f));
  stage.add("truncated cone", cone(1.15, 0.75, 0.35), moved({2.45, 0.575, -0.5}),
            stage.paint("green", 0x4c9a5a, 0.6f));

  Shape box;
  box.type = Shape::Type::box;
  box.size = {1.2, 0.9, 0.8};
  stage.add("box", box, turned({-0.75, 0.45, 0.75}, 28.0), stage.paint("violet", 0x7d5ba6, 0.7f));

  // The disk is tilted above the plane: its shadow is an ellipse that touches nothing.
  const int disk_paint = stage.paint("orange", 0xe07b39, 0.6f);
  stage.make_double_sided(disk_paint);
  stage.add("disk", round(Shape::Type::disk, 0.6), facing({0.85, 0.5, 1.2}, {-0.3, 1.0, 0.35}),
            disk_paint);

  stage.sun("sky", {0.3, -1.0, 0.2}, 0xd5e2ff, 0.7f);
  stage.sun("fill", {-0.03, -0.06, -1.0}, 0xdfe9ff, 0.6f);
  stage.camera("front", {0.25, 3.5, 7.0}, {0.05, 0.72, -0.3}, 34.0);
  stage.camera("low", {-3.6, 0.9, 4.6}, {0.1, 0.75, -0.5}, 42.0);
}

}  // namespace

Scene make_primitives() {
  SceneAssembler stage("primitives");
  stage.lamp("lamp", lamp_place, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

// The lights of figure 6 have a size of about a quarter of their distance. All give the same
// illuminance at the shapes.

Scene make_primitives_ball() {
  SceneAssembler stage("primitives-ball");
  stage.ball("ball", lamp_place, 1.0, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

Scene make_primitives_linear() {
  SceneAssembler stage("primitives-linear");
  const glm::dvec3 half(1.25, 0.0, 0.0);
  stage.tube("tube", lamp_place - half, lamp_place + half, lamp_srgb, lamp_candela);
  furnish(stage);
  return stage.take();
}

Scene make_primitives_rectangle() {
  SceneAssembler stage("primitives-rectangle");
  // The rectangle hangs level, so its outline as seen from the origin shrinks by a cosine; a higher
  // luminance compensates for that.
  constexpr double side = 2.0;
  const double cosine = lamp_place.y / glm::length(lamp_place);
  const double nits = static_cast<double>(lamp_candela) / (side * side * cosine);
  stage.panel("panel", lamp_place, lamp_place - glm::dvec3(0, 1, 0), {side, side}, lamp_srgb,
              static_cast<float>(nits));
  furnish(stage);
  return stage.take();
}

// CGF'98 figure 21: mirrors of three tints, so close together that there are reflections of
// reflections, on a plane that reflects nothing.
Scene make_solids() {
  SceneAssembler stage("solids");
  Mesh plane;
  add_quad(plane, {-300, 0, 300}, {300, 0, 300}, {300, 0, -300}, {-300, 0, -300});
  stage.add("plane", std::move(plane), stage.paint("plane", 0xa85f4a, 1.0f));
  stage.material("plane").specular = 0.0f;

  const auto mirror = [&stage](const std::string& name, std::uint32_t srgb) {
    return stage.paint(name, srgb, 0.0f, 1.0f);
  };
  stage.add("sphere", round(Shape::Type::sphere, 0.85), moved({-0.85, 0.85, 0.3}),
            mirror("gold", 0xf5d27e));
  stage.add("cylinder", cone(2.2, 0.65, 0.65), moved({0.3, 1.1, -0.85}), mirror("green", 0xb9e6c0));
  stage.add("cone", cone(1.9, 0.8, 0.0), moved({0.95, 0.95, 0.6}), mirror("copper", 0xf0a583));

  // The lamp has 0.8 of the apparent size of the ball of primitives-ball, and is far enough that
  // the plane reflected in the mirrors is lit evenly.
  constexpr double farther = 5.0;
  stage.ball("ball", farther * lamp_place, farther * 0.8, lamp_srgb,
             static_cast<float>(farther * farther) * lamp_candela);
  stage.camera("front", {0.1, 2.9, 5.5}, {0.08, 0.85, -0.05}, 31.0);
  stage.camera("low", {-3.4, 0.9, 3.6}, {0.1, 0.8, -0.2}, 42.0);
  return stage.take();
}

}  // namespace asos::builtin
