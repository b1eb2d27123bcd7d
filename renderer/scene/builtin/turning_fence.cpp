#include "renderer/scene/builtin/moving.h"
#include "renderer/scene/builtin/picket_fence.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace asos::builtin {

// A fence that turns about its centre. Its pickets are a few pixels wide where they face the viewer
// and a fraction of a pixel where they are seen edge-on, so their outlines creep over the pixels.
Scene make_turning_fence() {
  constexpr double seconds_a_turn = 30.0;
  SceneAssembler stage("turning-fence");
  Mesh ground;
  add_quad(ground, {-40, 0, 40}, {40, 0, 40}, {40, 0, -40}, {-40, 0, -40});
  stage.add("ground", std::move(ground), stage.paint("lawn", 0x8fa864, 1.0f));

  PicketFence plan;
  plan.pickets = 17;
  plan.spacing = 0.12f;
  plan.width = 0.05f;
  Mesh fence;
  add_picket_fence(fence, plan);
  const float length = plan.spacing * static_cast<float>(plan.pickets - 1) + plan.width;
  for (glm::vec3& p : fence.positions) p -= glm::vec3(0.5f * length, -0.02f, 0.0f);
  const int kept = stage.keep("fence", std::move(fence), stage.paint("white", 0xe8e4da));
  stage.place("fence", kept, glm::dmat4(1.0));

  stage.sun("sun", {-0.5, -0.8, -0.6}, 0xfff1d6, 2.6f, sun_diameter_rad);
  stage.sun("fill", {-0.1, -0.45, -1.0}, 0xe4ecff, 0.6f);
  stage.camera("lawn", {0.0, 1.1, 3.6}, {0.0, 0.45, 0.0}, 30.0);
  Scene scene = stage.take();
  const std::size_t fence_instance = scene.instances.size() - 1;
  return with_animation(std::move(scene), "turn", seconds_a_turn,
                        {{fence_instance, [](double seconds) {
                            return turned({}, 360.0 * seconds / seconds_a_turn);
                          }}});
}

}  // namespace asos::builtin
