#include "renderer/scene/builtin/picket_fence.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace asos::builtin {

namespace {

void place_box(SceneAssembler& stage, const std::string& name, glm::vec3 size, glm::dvec3 foot,
               double turn, int material) {
  Mesh mesh;
  const glm::vec3 half(0.5f * size.x, 0.0f, 0.5f * size.z);
  add_box(mesh, -half, glm::vec3(half.x, size.y, half.z));
  stage.place(name, stage.keep(name, std::move(mesh), material), turned(foot, turn));
}

}  // namespace

// Flat-coloured boxes in front of a picket fence: the smallest scene. Nearly every boundary is a
// straight edge between large faces.
Scene make_boxes() {
  SceneAssembler stage("boxes");
  const int red = stage.paint("red", 0xc94a3b);
  const int blue = stage.paint("blue", 0x3b6ea8);
  const int yellow = stage.paint("yellow", 0xe5b84b);
  const int green = stage.paint("green", 0x5f9e62);
  const int grey = stage.paint("grey", 0x9aa0a6);

  Mesh ground;
  add_quad(ground, {-2000, 0, 900}, {2000, 0, 900}, {2000, 0, -900}, {-2000, 0, -900});
  stage.add("ground", std::move(ground), stage.paint("ground", 0xcfc8b6, 0.95f));

  place_box(stage, "tower", {0.8f, 2.0f, 0.8f}, {-1.15, 0, -0.55}, 24, red);
  place_box(stage, "slab", {1.9f, 0.45f, 1.0f}, {0.75, 0, -0.35}, -14, blue);
  place_box(stage, "block on the slab", {0.62f, 0.62f, 0.62f}, {0.95, 0.45, -0.35}, 20, yellow);
  place_box(stage, "small block", {0.42f, 0.42f, 0.42f}, {-0.35, 0, 0.75}, 38, green);
  place_box(stage, "low block", {0.75f, 0.24f, 0.42f}, {1.65, 0, 0.95}, 12, grey);
  place_box(stage, "leaning plank's rest", {0.3f, 0.85f, 0.3f}, {-2.25, 0, 0.25}, -8, yellow);

  // A thin plank leans from the ground towards the tower, and one lies across two blocks.
  Mesh planks;
  add_beam(planks, {0.02f, 0.03f, 1.32f}, {-0.72f, 1.55f, 0.22f}, 0.12f, 0.025f);
  add_beam(planks, {-2.6f, 0.865f, 0.45f}, {-1.75f, 0.865f, 0.05f}, 0.16f, 0.03f);
  stage.add("planks", std::move(planks), stage.paint("plank", 0xb98a5a));

  Mesh fence;
  add_picket_fence(fence, {.pickets = 20, .spacing = 0.26f, .width = 0.17f, .height = 1.15f});
  const int fence_mesh = stage.keep("fence", std::move(fence), stage.paint("white", 0xf2efe6));
  stage.place("fence", fence_mesh, turned({-3.0, 0.0, -1.75}, 4.0));

  stage.soft_sun("panel", {-0.15, 0.6, -0.3}, {-0.55, -0.85, -0.6}, 120.0, 0xfff3dc, 3.1f);
  stage.sun("sky", {0.25, -1.0, 0.15}, 0xc9dcff, 0.45f);
  stage.sun("fill", {-0.25, -0.06, -1.0}, 0xe4ecff, 0.6f);
  stage.camera("front", {1.3, 2.05, 5.4}, {-0.15, 0.62, -0.5}, 36.0);
  stage.camera("along the fence", {3.3, 1.1, 0.4}, {-2.0, 0.6, -1.4}, 45.0);
  return stage.take();
}

}  // namespace asos::builtin
