#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace asos::builtin {

namespace {

/// A plump seated animal: ears, muzzle, eyes, arms, belly and feet as bumps on a furry egg.
Blob figure() {
  const auto towards = [](float x, float y, float z) { return glm::normalize(glm::vec3(x, y, z)); };
  Blob blob;
  blob.bumps = {{towards(0.0f, -0.25f, 0.95f), 0.10f, 5.0f},
                {towards(0.0f, 0.50f, 0.85f), 0.09f, 60.0f},
                {towards(0.0f, 0.56f, 0.83f), 0.03f, 1500.0f},
                {towards(0.0f, -1.0f, 0.0f), 0.10f, 3.0f}};
  for (const float side : {-1.0f, 1.0f}) {
    blob.bumps.push_back({towards(0.42f * side, 0.9f, 0.0f), 0.30f, 90.0f});
    blob.bumps.push_back({towards(0.22f * side, 0.68f, 0.7f), 0.035f, 1200.0f});
    blob.bumps.push_back({towards(0.75f * side, 0.0f, 0.65f), 0.14f, 40.0f});
    blob.bumps.push_back({towards(0.45f * side, -0.8f, 0.7f), 0.30f, 35.0f});
  }
  blob.ripples = {{{38.0f, 17.0f, -31.0f}, 0.0012f, 0.4f}, {{-25.0f, 44.0f, 29.0f}, 0.0012f, 1.1f}};
  return blob;
}

Blob pebble() {
  return {{{glm::normalize(glm::vec3(0.6f, 0.7f, 0.2f)), 0.25f, 6.0f}},
          {{{4.0f, 2.0f, -3.0f}, 0.10f, 0.3f},
           {{-7.0f, 6.0f, 5.0f}, 0.055f, 1.7f},
           {{13.0f, 15.0f, -9.0f}, 0.022f, 0.9f},
           {{-26.0f, 21.0f, 30.0f}, 0.009f, 2.2f}}};
}

Blob urchin() {
  Blob blob;
  // Points of a golden spiral, evenly spread over the sphere.
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / count;
    const float turn = 2.39996323f * static_cast<float>(i), ring = std::sqrt(1.0f - y * y);
    blob.bumps.push_back({{ring * std::cos(turn), y, ring * std::sin(turn)}, 0.28f, 70.0f});
  }
  return blob;
}

}  // namespace

// 1.2 million triangles, nearly all of them in four smooth closed meshes. The silhouettes are long,
// but few of the triangles lie on them.
Scene make_dense() {
  SceneAssembler stage("dense");
  Mesh ground;
  add_quad(ground, {-2000, 0, 900}, {2000, 0, 900}, {2000, 0, -900}, {-2000, 0, -900});
  stage.add("ground", std::move(ground), stage.paint("ground", 0xd2cec5, 0.95f));

  Mesh statue;  // 401,408 triangles
  add_blob(statue, {0.0f, 1.0f, -0.4f}, {0.7f, 0.98f, 0.62f}, figure(), 224);
  stage.add("statue", std::move(statue), stage.paint("marble", 0xe9e4da, 0.4f));

  Mesh stone;  // 259,200 triangles
  add_blob(stone, {-1.75f, 0.58f, 0.15f}, {0.72f, 0.6f, 0.68f}, pebble(), 180);
  stage.add("stone", std::move(stone), stage.paint("slate", 0x6d7f8e, 0.6f));

  Mesh spiny;  // 259,200 triangles
  add_blob(spiny, {0.85f, 0.43f, 0.95f}, glm::vec3(0.36f), urchin(), 180);
  stage.add("urchin", std::move(spiny), stage.paint("plum", 0x8a4f7d, 0.5f));

  Mesh knot;  // 1000 x 140 x 2 = 280,000 triangles
  add_torus_knot(knot, {}, {3, 4, 0.55f, 0.22f, 0.1f}, 1000, 140);
  const int knot_mesh =
      stage.keep("torus knot", std::move(knot), stage.paint("copper", 0xc77b4a, 0.35f));
  stage.place("torus knot", knot_mesh,
              turned({1.85, 0.8, -0.35}, -30.0) *
                  glm::rotate(glm::dmat4(1.0), glm::radians(68.0), glm::dvec3(1, 0, 0)));

  stage.soft_sun("panel", {0.1, 0.9, -0.2}, {0.65, -0.9, -0.6}, 120.0, 0xfff1da, 3.1f);
  stage.sun("sky", {-0.2, -1.0, 0.1}, 0xccdcff, 0.4f);
  stage.sun("fill", {0.08, -0.06, -1.0}, 0xe6edff, 0.6f);
  stage.camera("front", {-0.35, 1.8, 5.7}, {0.1, 0.95, -0.2}, 34.0);
  stage.camera("statue", {-0.9, 2.1, 2.2}, {0.0, 1.5, -0.4}, 42.0);
  return stage.take();
}

}  // namespace asos::builtin
