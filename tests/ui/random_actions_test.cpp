#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <thread>

// A thousand seeded actions of somebody who clicks, drags, types and opens scenes without waiting,
// and what has to hold afterwards. Under the sanitizers there are no reports.

namespace asos {
namespace {

using test::UiRig;

/// Scenes of several sorts, some of which take a moment to load, and some of which do not.
Result<Scene> load_some(const std::string& source) {
  if (source.find("slow") != std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  if (source.find("bad") != std::string::npos) return unexpected(Error{source, "is broken"});
  if (source.find("throws") != std::string::npos) throw std::runtime_error("thrown");
  if (source.find("grating") != std::string::npos) return test::grating(source);
  Scene scene = test::two_triangles({0.5f, 0.6f, 0.9f}, source);
  scene.materials[0].unlit = false;
  if (source.find("empty") != std::string::npos) scene.instances.clear();
  if (source.find("lit") != std::string::npos) {
    Light light;
    light.position = {0, 1, 2};
    light.radius = 0.2;
    scene.lights.assign(2, light);
    scene.lights[1].type = Light::Type::directional;
  }
  return scene;
}

class RandomUser {
 public:
  RandomUser(UiRig& rig, unsigned seed) : rig_(rig), random_(seed) {}

  void act() {
    switch (below(16)) {
      case 0:
      case 1:
        return open();
      case 2:
        return rig_.previewer().scene().reload();
      case 3:
        return add(WheelTurned{{0.0f, below(2) == 0 ? 1.0f : -1.0f}});
      case 4:
      case 5:
        return press_key();
      case 6:
        return add(TextTyped{static_cast<char32_t>("0123456789.-e/"[below(14)])});
      case 7:
        return resize();
      case 8:
      case 9:
      case 10:
      case 11:
        return use_control();
      case 12:
        return add(FocusLost{});
      default:
        break;
    }
    // Buttons go down and up anywhere, with moves between.
    const auto button = static_cast<MouseButton>(below(3));
    add(MouseMoved{anywhere()});
    add(MouseChanged{button, true});
    add(MouseMoved{anywhere()});
    if (below(4) != 0) add(MouseChanged{button, false});
  }

 private:
  unsigned below(unsigned count) { return static_cast<unsigned>(random_()) % count; }
  float share() { return static_cast<float>(below(1001)) / 1000.0f; }
  glm::vec2 anywhere() { return glm::vec2(rig_.size()) * glm::vec2(share(), share()); }
  void add(InputEvent event) { rig_.content().input().add(std::move(event)); }

  void open() {
    constexpr const char* sources[] = {"plain", "slow lit", "grating", "bad",      "slow grating",
                                       "lit",   "empty",    "throws",  "gone.png", "slow bad"};
    rig_.previewer().scene().open(sources[below(10)]);
  }
  void press_key() {
    const Key key = static_cast<Key>(1 + below(static_cast<unsigned>(Key::count) - 1));
    add(KeyChanged{key, true});
    if (below(8) != 0) add(KeyChanged{key, false});
  }
  void resize() {
    if (below(4) == 0) rig_.resize({0, 0});  // minimised
    rig_.resize({40 + static_cast<int>(below(400)), 40 + static_cast<int>(below(300))});
  }
  void use_control() {
    const auto& all = rig_.content().controls().all();
    if (all.empty()) return;
    const Controls::Placed at =
        std::next(all.begin(), below(static_cast<unsigned>(all.size())))->second;
    add(MouseMoved{glm::mix(at.lo, at.hi, glm::vec2(share(), 0.5f))});
    add(MouseChanged{MouseButton::left, true});
    if (below(2) == 0) add(MouseMoved{anywhere()});
    add(MouseChanged{MouseButton::left, false});
  }

  UiRig& rig_;
  std::mt19937 random_;
};

TEST(RandomActions, AThousandLeaveAWorkingWindow) {
  const test::TemporaryFolder folder;
  setenv("XDG_PICTURES_DIR", folder.path().c_str(), 1);
  constexpr int runs = 4, actions = 250;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    SCOPED_TRACE(seed);
    UiRig rig(load_some, {360, 240});
    // Saved pictures go nowhere else, whatever is typed; and no study runs for minutes.
    const RenderSettings before = rig.previewer().edits().settings();
    RandomUser user(rig, seed);
    for (int i = 0; i < actions; ++i) {
      user.act();
      rig.frame();
    }

    // Nothing is stuck: what is asked for next is done.
    rig.content().state() = UiState{};
    rig.content().state().save.stem = folder.file("x");
    for (const auto button : {MouseButton::left, MouseButton::right, MouseButton::middle})
      rig.content().input().add(MouseChanged{button, false});
    for (int key = 1; key < static_cast<int>(Key::count); ++key)
      rig.content().input().add(KeyChanged{static_cast<Key>(key), false});
    rig.resize({360, 240});
    rig.previewer().edits().settings() = before;
    rig.previewer().scene().open("lit");
    ASSERT_TRUE(rig.frames_until([&] {
      return rig.previewer().scene() && rig.previewer().scene()->geometry->source == "lit" &&
             !rig.previewer().scene().loading();
    }));
    rig.previewer().edits().settings() = before;
    // What was typed last may have been the pause.
    ASSERT_TRUE(rig.frames_until([&] { return rig.content().input().empty(); }));
    rig.frame();
    rig.previewer().refinement().limits() = {};
    rig.previewer().refinement().set_paused(false);
    rig.previewer().render().start_again();
    rig.content().state() = UiState{};
    ASSERT_TRUE(rig.frames_until([&] {
      return rig.content().input().empty() && rig.previewer().render().progress().finished;
    })) << rig.previewer().render().progress().fraction
        << " of the picture, resting for reason "
        << static_cast<int>(rig.previewer().refinement().rest());
    const Film& film = rig.previewer().render().film();
    ASSERT_GT(film.width, 0);
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      const glm::vec3 c = film.radiance[i];
      ASSERT_TRUE(std::isfinite(c.x + c.y + c.z)) << "pixel " << i;
      ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0f) << "pixel " << i;
    }
  }
  unsetenv("XDG_PICTURES_DIR");
}

}  // namespace
}  // namespace asos
