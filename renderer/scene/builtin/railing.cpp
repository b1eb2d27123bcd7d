#include "renderer/scene/builtin/cut_outs.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <utility>

namespace asos::builtin {

// A wrought-iron railing along a terrace: a few cards and their shadows. One repeated image cuts
// out the bars, rings and lozenges.
Scene make_railing() {
  SceneAssembler stage("railing");
  Mesh ground;
  add_quad(ground, {-40, 0, 12}, {40, 0, 12}, {40, 0, -60}, {-40, 0, -60});
  stage.add("terrace", std::move(ground), stage.paint("terrace", 0xcabfa8, 0.95f));

  Mesh iron;
  constexpr float height = 1.0f, length = 2.0f;
  // Each panel shows 4 x 2 whole squares of the image, and the bar at its end.
  const glm::vec2 uv_lo(-0.03f), uv_hi(4.03f, 2.03f);
  for (int i = 0; i < 3; ++i) {
    const float x = -3.2f + 2.1f * static_cast<float>(i);
    add_card(iron, {x, 0.1f + height, 0.0f}, {length, 0, 0}, {0, -height, 0}, uv_lo, uv_hi);
  }
  // Two panels round the corner, towards the viewer.
  for (int i = 0; i < 2; ++i) {
    const float z = 2.05f * static_cast<float>(i) + 0.06f;
    add_card(iron, {3.1f, 0.1f + height, z}, {0, 0, length}, {0, -height, 0}, uv_lo, uv_hi);
  }
  stage.add("railing", std::move(iron), paint_cut_out(stage, "iron", wrought_iron(), Wrap::repeat));

  Mesh posts;
  for (int i = 0; i < 4; ++i) {
    const float x = -3.25f + 2.1f * static_cast<float>(i);
    add_box(posts, {x - 0.04f, 0.0f, -0.04f}, {x + 0.04f, 1.2f, 0.04f});
  }
  for (int i = 1; i < 3; ++i) {
    const float z = 2.05f * static_cast<float>(i) + 0.035f;
    add_box(posts, {3.06f, 0.0f, z - 0.04f}, {3.14f, 1.2f, z + 0.04f});
  }
  stage.add("posts", std::move(posts), stage.paint("post", 0x3d4247));

  Mesh box;
  add_box(box, {-1.6f, 0.0f, 0.9f}, {-0.7f, 0.55f, 1.8f});
  stage.add("tub", std::move(box), stage.paint("clay", 0xb5603f));

  stage.sun("sun", {-0.45, -0.8, 0.55}, 0xfff1d6, 2.6f);
  stage.sun("fill", {-0.1, -0.45, -1.0}, 0xe4ecff, 0.6f);
  stage.camera("terrace", {0.9, 2.0, 6.3}, {0.15, 0.5, 0.4}, 34.0);
  stage.camera("along", {2.7, 0.9, 5.4}, {3.0, 0.5, 0.0}, 40.0);
  return stage.take();
}

}  // namespace asos::builtin
