#pragma once

#include "renderer/gltf/load.h"
#include "tests/ui/test_scenes.h"
#include "ui/previewer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

namespace asos::test {
using namespace ui;

/// Loads "red", "green", "slow" (green, after `release`), "lines" (red, with a line), "wide" (red,
/// with a camera of aspect ratio 3) and "many" (many triangles); any other name is an error.
class Loader {
 public:
  LoadFunction function() {
    return [this](const std::string& source) -> Result<Scene> {
      ++calls;
      if (source == "red") return two_triangles({1, 0, 0}, source);
      if (source == "green") return two_triangles({0, 1, 0}, source);
      if (source == "slow") {
        while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return two_triangles({0, 1, 0}, source);
      }
      if (source == "lines") {
        Scene scene = two_triangles({1, 0, 0}, source);
        Mesh line{.positions = {{-1, 0, 0.5f}, {1, 0.1f, 0.5f}}, .segments = {{0, 1}}};
        scene.instances.push_back({"line", static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
        scene.meshes.push_back(std::move(line));
        return scene;
      }
      if (source == "wide") {
        Scene scene = two_triangles({1, 0, 0}, source);
        Camera camera{.fov_y_rad = 0.5, .aspect_ratio = 3.0};
        camera.world_from_camera[3] = {0, 0, 5, 1};
        scene.cameras = {camera};
        return scene;
      }
      if (source == "many") {
        Result<Scene> scene = load_scene("builtin:dense");
        scene->source = source;
        return scene;
      }
      if (source == "huge") throw std::bad_alloc();
      if (source == "odd") throw std::runtime_error("an odd thing");
      return unexpected(Error{source, "there is no such file"});
    };
  }
  std::atomic<int> calls = 0;
  std::atomic<bool> released = false;
};

inline RenderSettings small_picture() {
  return {.asos = {.max_level = 2}, .threads = 1};
}

/// Scenes have neither ground nor sky, unless a test enables their default look.
class PreviewerTest : public testing::Test {
 protected:
  PreviewerTest() { previewer.edits().keep_first({true, true, true}); }

  bool update_until(const std::function<bool()>& done) {
    for (int i = 0; i < 20000 && !done(); ++i) {
      previewer.update(now);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  }
  bool opened(const std::string& source) {
    return update_until(
        [&] { return previewer.scene() && previewer.scene()->geometry->source == source; });
  }
  /// Opens a scene, in a picture of this size if one is given, and waits until it is shown.
  bool opens(const std::string& source, glm::ivec2 size = glm::ivec2(0)) {
    if (size.x > 0) previewer.viewpoint().set_picture_size(size.x, size.y, now);
    previewer.scene().open(source);
    return opened(source);
  }
  bool finished() {
    return update_until([&] {
      return previewer.render().progress().finished && !previewer.seconds_to_update(now);
    });
  }

  Loader loader;
  std::atomic<int> wakes = 0;
  Previewer previewer{{loader.function(), [this] { ++wakes; }}, small_picture()};
  double now = 0.0;
};

}  // namespace asos::test
