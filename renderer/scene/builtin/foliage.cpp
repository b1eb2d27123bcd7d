#include "renderer/scene/builtin/cut_outs.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scene_random.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace asos::builtin {

namespace {

// Appends a twig's card from its foot outwards, turned about its own axis.
void add_twig(Mesh& mesh, glm::vec3 foot, glm::vec3 way, float size, float turn) {
  const glm::vec3 up = glm::normalize(way);
  const glm::vec3 side = glm::normalize(glm::cross(up, glm::vec3(0.31f, 0.2f, 0.93f)));
  const glm::vec3 across = size * (std::cos(turn) * side + std::sin(turn) * glm::cross(up, side));
  add_card(mesh, foot + size * up - 0.5f * across, across, -size * up);
}

}  // namespace

// A young tree whose leaves are cards, and its shadow on the lawn. One image cuts out the leaves of
// each card.
Scene make_foliage() {
  SceneAssembler stage("foliage");
  Mesh lawn;
  add_quad(lawn, {-400, 0, 120}, {400, 0, 120}, {400, 0, -300}, {-400, 0, -300});
  stage.add("lawn", std::move(lawn), stage.paint("lawn", 0x9fb078, 0.95f));

  Mesh trunk, leaves;
  SceneRandom chance(17);
  add_frustum(trunk, {0, -0.02f, 0}, {0, 1.5f, 0}, 0.075f, 0.03f, 12);
  constexpr int boughs = 11, twigs = 11;
  for (int i = 0; i < boughs; ++i) {
    // Golden angles around the trunk. Higher twigs are shorter and steeper.
    const float height = 0.55f + 0.085f * static_cast<float>(i);
    const float angle = 2.399963f * static_cast<float>(i);
    const float reach = 0.75f - 0.045f * static_cast<float>(i);
    const glm::vec3 out(std::cos(angle), 0.35f + 0.05f * static_cast<float>(i), std::sin(angle));
    const glm::vec3 foot(0.0f, height, 0.0f), tip = foot + reach * out;
    add_frustum(trunk, foot, tip, 0.02f, 0.006f, 6);
    for (int k = 0; k < twigs; ++k) {
      const float along =
          0.3f + 0.7f * (static_cast<float>(k) + chance.between(0.0f, 1.0f)) / twigs;
      const glm::vec3 aside(chance.between(-0.5f, 0.5f), chance.between(-0.35f, 0.65f),
                            chance.between(-0.5f, 0.5f));
      add_twig(leaves, glm::mix(foot, tip, along), 0.6f * out + 1.6f * aside,
               chance.between(0.26f, 0.38f), chance.between(0.0f, std::numbers::pi_v<float>));
    }
  }
  stage.add("trunk", std::move(trunk), stage.paint("bark", 0x7a6248));
  stage.add("leaves", std::move(leaves), paint_cut_out(stage, "twig", twig(), Wrap::clamp_to_edge));

  stage.sun("sun", {0.55, -0.85, -0.3}, 0xfff1d6, 2.6f);
  stage.sun("fill", {-0.2, -0.4, -1.0}, 0xe4ecff, 0.7f);
  stage.camera("garden", {0.3, 1.35, 4.2}, {0.2, 0.85, 0.0}, 34.0);
  return stage.take();
}

}  // namespace asos::builtin
