#include "renderer/scene/builtin/moving.h"
#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace asos::builtin {

// A pole, half a pixel wide in a picture of 180 rows, that moves by a quarter of such a pixel in a
// 24th of a second. It leans, so that it enters pixels one by one.
Scene make_walking_pole() {
  constexpr double seconds = 10.0, metres_a_second = 0.1;
  SceneAssembler stage("walking-pole");
  Mesh ground;
  add_quad(ground, {-40, 0, 10}, {40, 0, 10}, {40, 0, -4}, {-40, 0, -4});
  stage.add("ground", std::move(ground), stage.paint("sand", 0xc9b48a, 1.0f));
  Mesh wall;
  add_quad(wall, {-40, 0, -4}, {40, 0, -4}, {40, 20, -4}, {-40, 20, -4});
  stage.add("wall", std::move(wall), stage.paint("plaster", 0xd9dee2, 1.0f));

  Mesh pole;
  add_frustum(pole, {0.0f, 0.01f, 0.0f}, {0.12f, 2.4f, 0.0f}, 0.0045f, 0.0045f, 12);
  const int kept = stage.keep("pole", std::move(pole), stage.paint("tar", 0x2c2620));
  const auto place = [](double at) {
    return glm::translate(glm::dmat4(1.0), {metres_a_second * (at - 0.5 * seconds), 0.0, 0.0});
  };
  stage.place("pole", kept, place(0.0));

  stage.sun("sun", {0.35, -0.8, -0.7}, 0xfff1d6, 2.4f);
  stage.sun("fill", {0.0, -0.3, -1.0}, 0xe4ecff, 0.7f);
  stage.camera("sand", {0.0, 1.5, 6.0}, {0.0, 1.15, 0.0}, 30.0);
  Scene scene = stage.take();
  const std::size_t pole_instance = scene.instances.size() - 1;
  return with_animation(std::move(scene), "walk", seconds, {{pole_instance, place}});
}

}  // namespace asos::builtin
