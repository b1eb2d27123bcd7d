#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <array>
#include <cmath>

namespace asos::builtin {

namespace {

constexpr float eye_distance = 6.0f;  // of the eye from the plane z = 0

// Moves a point of the plane z = 0 along its eye ray to another depth.
glm::vec3 at_depth(glm::vec2 seen, float z) {
  const float scale = (eye_distance - z) / eye_distance;
  return {scale * seen.x, scale * seen.y, z};
}

// Returns a quad at depth `z` whose corners project to `seen` on the plane z = 0,
// counter-clockwise.
Mesh card(const std::array<glm::vec2, 4>& seen, float z) {
  Mesh mesh;
  add_quad(mesh, at_depth(seen[0], z), at_depth(seen[1], z), at_depth(seen[2], z),
           at_depth(seen[3], z));
  return mesh;
}

int plain(SceneAssembler& stage, const char* name, std::uint32_t srgb) {
  const int material = stage.paint(name, srgb);
  stage.material(name).unlit = true;
  return material;
}

}  // namespace

// Counterexamples for methods that only track covered fractions of a pixel (CGF'98 sections 2.7 and
// 2.8): cards with coinciding edges, one behind the other and side by side; wires thinner than a
// pixel; a thin bar and its shadow.
Scene make_cards() {
  SceneAssembler stage("cards");
  const int black = plain(stage, "black", 0x000000), red = plain(stage, "red", 0xff3b30);
  const int green = plain(stage, "green", 0x30d158), white = plain(stage, "white", 0xffffff);
  stage.add("wall", card({{{-6, -4}, {6, -4}, {6, 4}, {-6, 4}}}, -4.0f), black);

  // The green card is completely hidden by the red one.
  const std::array<glm::vec2, 4> upper_left{
      {{-2.7f, 0.15f}, {-1.6f, 0.15f}, {-1.3f, 1.5f}, {-2.5f, 1.5f}}};
  stage.add("front", card(upper_left, 0.0f), red);
  stage.add("hidden", card(upper_left, -1.0f), green);

  // Together these two hide the wall completely.
  stage.add("left", card({{{0.2f, 0.15f}, {1.2f, 0.15f}, {1.5f, 1.5f}, {0.4f, 1.5f}}}, 0.0f), red);
  stage.add("right", card({{{1.2f, 0.15f}, {2.5f, 0.15f}, {2.6f, 1.5f}, {1.5f, 1.5f}}}, -1.0f),
            green);

  Mesh wires;
  for (int i = 0; i < 9; ++i) {
    const float angle = 0.1f + 0.15f * static_cast<float>(i);
    const glm::vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const glm::vec2 from = glm::vec2(-2.7f, -1.6f) + 0.5f * along, to = from + 1.0f * along;
    const glm::vec2 half = 0.002f * across;
    add_quad(wires, at_depth(from - half, 0.0f), at_depth(to - half, 0.0f),
             at_depth(to + half, 0.0f), at_depth(from + half, 0.0f));
  }
  stage.add("wires", std::move(wires), white);

  stage.add("plate", card({{{0.2f, -1.6f}, {2.6f, -1.6f}, {2.6f, -0.2f}, {0.2f, -0.2f}}}, -0.6f),
            stage.paint("plate", 0xd8d8d8, 1.0f));
  stage.add("bar", card({{{0.5f, -1.5f}, {0.51f, -1.5f}, {1.71f, -0.3f}, {1.7f, -0.3f}}}, 0.1f),
            stage.paint("bar", 0x2060c0, 1.0f));
  stage.panel("panel", {-0.6, 0.4, 3.0}, {1.4, -0.9, -0.6}, {0.3, 0.3}, 0xffffff, 260.0f);
  stage.camera("front", {0, 0, eye_distance}, {0, 0, 0}, 33.0);
  return stage.take();
}

}  // namespace asos::builtin
