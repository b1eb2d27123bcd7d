#include "renderer/scene/builtin/picket_fence.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace asos::builtin {

// About 50 thousand triangles with all kinds of boundaries: smooth silhouettes (a sphere and a
// torus knot, finely tessellated), straight edges (boxes) and thin objects (a fence).
Scene make_mixed() {
  SceneAssembler stage("mixed");
  Mesh ground;
  add_quad(ground, {-2000, 0, 900}, {2000, 0, 900}, {2000, 0, -900}, {-2000, 0, -900});
  stage.add("ground", std::move(ground), stage.paint("ground", 0xc9cdd2, 0.95f));

  Mesh sphere;
  add_sphere(sphere, {1.35f, 0.7f, 0.25f}, 0.7f, 42);  // 14,112 triangles
  stage.add("sphere", std::move(sphere), stage.paint("red", 0xc2452d, 0.3f));

  // The knot stands on edge on a plinth: 600 x 30 x 2 = 36,000 triangles.
  Mesh knot;
  add_torus_knot(knot, {}, {2, 3, 0.62f, 0.26f, 0.13f}, 600, 30);
  const int knot_mesh =
      stage.keep("torus knot", std::move(knot), stage.paint("teal", 0x2f8f8a, 0.4f));
  const glm::dmat4 upright{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {-0.55, 1.47, -0.3, 1}};
  stage.place("torus knot", knot_mesh, upright * turned({}, 14.0));

  Mesh plinth;
  add_box(plinth, {-1.15f, 0.0f, -0.75f}, {0.05f, 0.45f, 0.15f});
  stage.add("plinth", std::move(plinth), stage.paint("stone", 0xa9a294));

  Mesh block;
  add_box(block, {-0.3f, 0.0f, -0.3f}, {0.3f, 0.6f, 0.3f});
  const int block_mesh = stage.keep("block", std::move(block), stage.paint("yellow", 0xe2b04a));
  stage.place("left block", block_mesh, turned({-2.05, 0.0, 0.35}, 33.0));
  stage.place("upper block", block_mesh, turned({-2.05, 0.6, 0.35}, 62.0));
  stage.place("right block", block_mesh, turned({2.55, 0.0, -0.7}, -20.0));

  Mesh fence;
  add_picket_fence(fence, {.pickets = 28, .spacing = 0.24f, .width = 0.13f, .height = 1.25f});
  const int fence_mesh = stage.keep("fence", std::move(fence), stage.paint("white", 0xf4f1ea));
  stage.place("fence", fence_mesh, turned({-3.4, 0.0, -1.75}, -3.0));

  stage.soft_sun("panel", {0.0, 0.7, -0.3}, {0.6, -0.9, -0.65}, 120.0, 0xfff2dd, 3.1f);
  stage.sun("sky", {-0.2, -1.0, 0.1}, 0xccdcff, 0.45f);
  stage.sun("fill", {0.12, -0.06, -1.0}, 0xe6edff, 0.6f);
  stage.camera("front", {-0.5, 1.75, 5.6}, {0.05, 0.78, -0.4}, 36.0);
  stage.camera("knot", {0.9, 1.6, 2.2}, {-0.5, 1.25, -0.3}, 40.0);
  return stage.take();
}

}  // namespace asos::builtin
