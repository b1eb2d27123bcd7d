#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <array>
#include <cmath>

namespace asos::builtin {

namespace {

/// A strand that hangs in `spans` equal arcs, each `step` long, as straight pieces.
void add_sagging_wire(Mesh& mesh, glm::vec3 from, glm::vec3 step, int spans, float sag,
                      float radius) {
  constexpr int pieces = 12;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= spans * pieces; ++i) {
    const float t = static_cast<float>(i) / pieces, within = t - std::floor(t);
    const float drop = 4.0f * sag * within * (1.0f - within);
    path.push_back(from + t * step - glm::vec3(0.0f, drop, 0.0f));
  }
  add_tube(mesh, path, radius, 6);
}

/// A pasture fence: posts as thick as an arm, five wires as thick as a pencil lead.
void add_pasture_fence(Mesh& posts, Mesh& wires, glm::vec3 from, glm::vec3 step, int count) {
  for (int i = 0; i < count; ++i) {
    const glm::vec3 foot = from + static_cast<float>(i) * step;
    add_frustum(posts, foot, foot + glm::vec3(0.0f, 1.3f, 0.0f), 0.045f, 0.04f, 10);
  }
  const glm::vec3 along = static_cast<float>(count - 1) * step;
  const glm::vec3 across = 0.047f * glm::normalize(glm::cross(step, glm::vec3(0, 1, 0)));
  for (int i = 0; i < 5; ++i) {
    const glm::vec3 start =
        from + across + glm::vec3(0.0f, 0.25f + 0.22f * static_cast<float>(i), 0.0f);
    add_beam(wires, start - 0.02f * glm::normalize(step), start + along, 0.002f, 0.002f);
  }
}

/// Poles with two arms, and eight wires that sag from pole to pole, away to the horizon.
void add_power_line(Mesh& poles, Mesh& wires, glm::vec3 from, glm::vec3 step, int count) {
  const glm::vec3 along = glm::normalize(step);
  const glm::vec3 across = glm::normalize(glm::cross(step, glm::vec3(0, 1, 0)));
  for (int i = 0; i < count; ++i) {
    const glm::vec3 foot = from + static_cast<float>(i) * step;
    add_frustum(poles, foot, foot + glm::vec3(0.0f, 9.0f, 0.0f), 0.14f, 0.09f, 12);
    for (const float y : {7.6f, 8.5f}) {
      const glm::vec3 arm = foot + glm::vec3(0.0f, y, 0.0f) + 0.15f * along;
      add_beam(poles, arm - 1.1f * across, arm + 1.1f * across, 0.09f, 0.12f);
    }
  }
  for (const float y : {7.68f, 8.58f}) {
    for (const float x : {-1.0f, -0.45f, 0.45f, 1.0f}) {
      const glm::vec3 start = from + glm::vec3(0.0f, y, 0.0f) + x * across + 0.15f * along;
      add_sagging_wire(wires, start, step, count - 1, 0.55f, 0.006f);
    }
  }
}

/// A garden rail of thin upright rods between two bars, as in front of a house.
void add_rod_rail(Mesh& mesh, glm::vec3 from, glm::vec3 to, int rods) {
  const glm::vec3 along = to - from, up(0.0f, 1.0f, 0.0f);
  for (const float y : {0.12f, 0.95f}) {
    add_beam(mesh, from + y * up, to + y * up, 0.024f, 0.03f);
  }
  for (int i = 0; i < rods; ++i) {
    const glm::vec3 foot = from + (static_cast<float>(i) + 0.5f) / static_cast<float>(rods) * along;
    add_frustum(mesh, foot + 0.02f * up, foot + 1.08f * up, 0.004f, 0.004f, 8);
  }
}

}  // namespace

// Very thin poles and wires from close by to the horizon, some far thinner than a pixel. Point
// samples break them into dashes.
Scene make_fence() {
  SceneAssembler stage("fence");
  Mesh ground;
  add_quad(ground, {-4000, 0, 4000}, {4000, 0, 4000}, {4000, 0, -4000}, {-4000, 0, -4000});
  stage.add("ground", std::move(ground), stage.paint("grass", 0x9db36a, 1.0f));

  Mesh road;  // slightly above the ground, so that nothing is coplanar
  add_box(road, {-2.2f, 0.0f, -1500.0f}, {2.2f, 0.05f, 30.0f});
  stage.add("road", std::move(road), stage.paint("road", 0xb9b2a6, 0.95f));

  const int wood = stage.paint("wood", 0xb08a62, 0.9f);
  const int steel = stage.paint("steel", 0x3c4048, 0.5f);

  Mesh posts, strands;
  add_pasture_fence(posts, strands, {3.4f, 0.0f, 3.0f}, {0.0f, 0.0f, -3.0f}, 120);
  add_pasture_fence(posts, strands, {-3.6f, 0.0f, -9.0f}, {0.0f, 0.0f, -4.0f}, 60);
  add_pasture_fence(posts, strands, {-80.0f, 0.0f, -60.0f}, {4.0f, 0.0f, 0.0f}, 19);
  stage.add("fence posts", std::move(posts), wood);
  stage.add("fence wires", std::move(strands), steel);

  Mesh poles, wires;
  add_power_line(poles, wires, {7.5f, 0.0f, -8.0f}, {0.4f, 0.0f, -38.0f}, 30);
  stage.add("poles", std::move(poles), stage.paint("tarred wood", 0x8d7763, 0.9f));
  stage.add("power lines", std::move(wires), steel);

  Mesh rail;
  add_rod_rail(rail, {-3.4f, 0.0f, 0.4f}, {-3.2f, 0.0f, -6.0f}, 70);
  stage.add("rod rail", std::move(rail), stage.paint("iron", 0x2e3238, 0.5f));

  // Masts on the horizon, with guy wires.
  Mesh masts;
  for (const glm::vec3 foot :
       {glm::vec3(-95, 0, -260), glm::vec3(-210, 0, -600), glm::vec3(60, 0, -900)}) {
    const glm::vec3 top = foot + glm::vec3(0.0f, 48.0f, 0.0f);
    add_frustum(masts, foot, top, 0.25f, 0.12f, 10);
    for (int i = 0; i < 3; ++i) {
      const float turn = 2.0943951f * static_cast<float>(i) + 0.4f;
      const glm::vec3 anchor = foot + 26.0f * glm::vec3(std::cos(turn), 0.0f, std::sin(turn));
      add_beam(masts, anchor, top - glm::vec3(0.0f, 4.0f, 0.0f), 0.03f, 0.03f);
    }
  }
  stage.add("masts", std::move(masts), stage.paint("mast", 0xb8483a, 0.6f));

  stage.sun("sun", {-0.75, -0.6, -0.4}, 0xfff0d8, 3.2f, sun_diameter_rad);
  stage.sun("sky", {0.2, -1.0, 0.2}, 0xcfe0ff, 0.6f);
  stage.sun("fill", {0.25, -0.06, -1.0}, 0xe6edff, 0.9f);
  stage.camera("down the road", {-1.1, 1.6, 4.4}, {0.7, 3.1, -12.0}, 50.0);
  stage.camera("along the wires", {3.25, 1.2, 3.2}, {3.45, 1.05, -6.0}, 40.0);
  return stage.take();
}

}  // namespace asos::builtin
