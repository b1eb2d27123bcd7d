#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <array>

namespace asos::builtin {

namespace {

/// Every other square of the floor.
Mesh chequers(int parity) {
  constexpr int squares = 20;  // along a side
  constexpr float square = 0.25f, side = squares * square;
  Mesh mesh;
  for (int x = 0; x < squares; ++x) {
    for (int z = 0; z < squares; ++z) {
      if ((x + z) % 2 != parity) continue;
      const glm::vec3 near(square * static_cast<float>(x) - 0.5f * side, 0.0f,
                           square * static_cast<float>(z + 1) - 0.6f * side);
      const glm::vec3 right(square, 0.0f, 0.0f), far(0.0f, 0.0f, -square);
      add_quad(mesh, near, near + right, near + right + far, near + far);
    }
  }
  return mesh;
}

int paint_glass(SceneAssembler& stage, const std::string& name, float index) {
  const int material = stage.paint(name, 0xffffff, 0.0f);
  Material& m = stage.material(name);
  m.transmission = 1.0f;
  m.ior = index;
  m.volume.thickness = 0.1f;
  return material;
}

}  // namespace

// Volumes of glass on a chequered floor: a ball, which inverts the image behind it; a green slab,
// whose tint depends on the path length; and a prism, which disperses the colours.
Scene make_glass() {
  SceneAssembler stage("glass");
  stage.add("dark squares", chequers(0), stage.paint("dark", 0x3d4654, 0.9f));
  stage.add("light squares", chequers(1), stage.paint("light", 0xe8e2d4, 0.9f));

  // The faces are slightly apart, since the hit order of coplanar faces is undefined.
  constexpr double clear = 0.004;
  glm::dmat4 place(1.0);
  place[3] = {-0.35, 0.5 + clear, 0.0, 1.0};
  Shape ball;
  ball.type = Shape::Type::sphere;
  ball.radius = 0.5;
  stage.add("ball", ball, place, paint_glass(stage, "crown glass", 1.52f));

  Mesh slab;
  add_box(slab, {-0.4f, 0.0f, -0.06f}, {0.4f, 0.9f, 0.06f});
  const int green = paint_glass(stage, "green glass", 1.5f);
  stage.material("green glass").volume.attenuation_color = {0.3f, 0.9f, 0.6f};
  stage.material("green glass").volume.attenuation_distance = 0.25f;
  stage.place("slab", stage.keep("slab", std::move(slab), green),
              turned({0.75, clear, -0.35}, -24));

  constexpr std::array<glm::vec2, 3> outline{{{-0.22f, 0.0f}, {0.22f, 0.0f}, {0.0f, 0.381f}}};
  Mesh prism;
  add_prism(prism, outline, 0.6f);
  const int flint = paint_glass(stage, "flint glass", 1.62f);
  stage.material("flint glass").volume.dispersion = 1.0f;
  stage.place("prism", stage.keep("prism", std::move(prism), flint),
              turned({0.3, clear, 0.75}, 80.0));

  stage.soft_sun("panel", {0.0, 0.4, 0.0}, {-0.5, -0.85, -0.35}, 40.0, 0xfff6e6, 2.6f);
  stage.sun("sky", {0.3, -1.0, 0.2}, 0xc9dcff, 0.5f);
  stage.camera("front", {0.45, 1.5, 3.4}, {0.1, 0.35, 0.0}, 32.0);
  stage.camera("through the ball", {-0.35, 0.75, 2.0}, {-0.35, 0.45, 0.0}, 36.0);
  return stage.take();
}

}  // namespace asos::builtin
