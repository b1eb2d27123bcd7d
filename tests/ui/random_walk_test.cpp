#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/walker.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

// A simulated user who clicks, drags, types, flies, resizes, plays, saves, opens scenes and closes
// the window without waiting, through the real window's loop; and invariants that must hold. The
// actions follow from a seed. Under the sanitizers the walk is longer and must give no reports.

namespace asos::test::random_walk_test {
using namespace ui;
namespace {

constexpr int actions = sanitized ? 2000 : 1000;

class RandomWalk : public testing::Test {
 protected:
  RandomWalk() {
    setenv("XDG_PICTURES_DIR", folder.path().c_str(), 1);
    setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  }
  ~RandomWalk() override {
    unsetenv("XDG_PICTURES_DIR");
    unsetenv("XDG_CONFIG_HOME");
  }

  // Requests closing twice, to skip the question about lost work.
  static void add_close(WalkedWindow& window) {
    const auto ask = [](WalkedWindow& w) { w.happened().asked_to_close = true; };
    window.steps.push_back({"close", ask});
    // A window that is minimised or loading reacts with delay.
    window.idle = ask;
  }
  /// Checks a window, and keeps the maxima over all windows.
  void note(const WalkedWindow& window) {
    EXPECT_LE(window.most().frames, 1) << "frames were drawn without processing events in between";
    frames += window.frames();
    if (window.most().wall_ms > slowest_wall.wall_ms) slowest_wall = window.most();
    if (window.most().processor_ms > slowest.processor_ms) slowest = window.most();
  }

  TemporaryFolder folder;
  WalkedWindow::Between slowest, slowest_wall;
  int frames = 0;
};

/// A quarter of the walk, so that no test takes too long.
class LongWalk : public RandomWalk, public testing::WithParamInterface<unsigned> {};
constexpr unsigned quarters = 4;
INSTANTIATE_TEST_SUITE_P(RandomWalk, LongWalk, testing::Range(1u, quarters + 1));

TEST_P(LongWalk, HearsWhatHappensWhateverIsDone) {
  constexpr int each = actions / quarters;
  Walker walker(GetParam(), folder.path().string());
  int done = 0, windows = 0;
  while (done < each) {
    SCOPED_TRACE(fmt::format("window {}, after {} actions", windows, done));
    ++windows;
    Session session;
    session.previewer.scene().open("lit");
    for (bool closed = false; done < each && !closed; ++done) {
      for (WalkedWindow::Step& step : walker.next(session))
        session.window.steps.push_back(std::move(step));
      closed = walker.closes();
    }
    add_close(session.window);
    session.run();
    note(session.window);
  }
  std::printf(
      "%d actions in %d windows, %d frames; between two polls at most %.0f ms of the main thread's "
      "processor (%s) and %.0f ms of the clock (%s)\n",
      done, windows, frames, slowest.processor_ms, slowest.processor_action.c_str(),
      slowest_wall.wall_ms, slowest_wall.wall_action.c_str());
}

// Actions after a walk still have their effect.
TEST_F(RandomWalk, LeavesNothingStuck) {
  constexpr unsigned windows = 3;
  constexpr int each = 80;
  for (unsigned seed = 1; seed <= windows; ++seed) {
    SCOPED_TRACE(seed);
    Walker walker(seed, folder.path().string());
    Session session;
    session.previewer.scene().open("plain");
    for (int i = 0; i < each; ++i)
      for (WalkedWindow::Step& step : walker.next(session))
        session.window.steps.push_back(std::move(step));
    // Releases all buttons and restores the settings.
    session.window.steps.push_back(
        {"let go", [](WalkedWindow& window) {
           for (const auto button : {MouseButton::left, MouseButton::right, MouseButton::middle})
             window.add(MouseChanged{button, false});
           for (int key = 1; key < static_cast<int>(Key::count); ++key)
             window.add(KeyChanged{static_cast<Key>(key), false});
           window.resize({360, 240});
         }});
    bool asked = false;
    const auto start = std::chrono::steady_clock::now();
    session.window.idle = [&](WalkedWindow&) {
      const double waited =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (waited > (sanitized ? 600.0 : 60.0)) session.content->state().leaving.quit = true;
      if (!session.content->input().empty()) return;
      if (!asked) {
        session.content->state() = UiState{};
        session.previewer.edits().settings() = Session::small_settings();
        session.previewer.refinement().limits() = {};
        session.previewer.refinement().set_paused(false);
        session.previewer.scene().open("lit");
        session.previewer.render().start_again();
      }
      asked = true;
      if (session.previewer.scene() && session.previewer.scene()->geometry->source == "lit" &&
          !session.previewer.scene().loading() && session.previewer.render().progress().finished)
        session.content->state().leaving.quit = true;
    };
    session.run();
    note(session.window);
    ASSERT_TRUE(session.previewer.scene());
    EXPECT_EQ(session.previewer.scene()->geometry->source, "lit");
    EXPECT_TRUE(session.previewer.render().progress().finished)
        << session.previewer.render().progress().fraction << " of the picture, resting for reason "
        << static_cast<int>(session.previewer.refinement().rest());
    const Film& film = session.previewer.render().film();
    ASSERT_GT(film.width, 0);
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      const glm::vec3 c = film.radiance[i];
      ASSERT_TRUE(std::isfinite(c.x + c.y + c.z)) << "pixel " << i;
      ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0f) << "pixel " << i;
    }
  }
}

// If frames took longer than their interval, key releases were once never processed, and the camera
// kept flying.
TEST_F(RandomWalk, AFlightEndsThoughEveryFrameIsLate) {
  Session session;
  session.window.seconds_per_frame = 0.1;
  session.previewer.scene().open("plain");
  const auto add = [&](const InputEvent& event) {
    session.window.steps.push_back({"fly", [event](WalkedWindow& w) { w.add(event); }});
  };
  const auto rest = [&](int steps) {
    for (int i = 0; i < steps; ++i) session.window.steps.push_back({"rest", [](WalkedWindow&) {}});
  };
  const std::function<void(WalkedWindow&)> load = [&](WalkedWindow& window) {
    if (!session.previewer.scene()) window.steps.push_front({"load", load});
  };
  session.window.steps.push_back({"load", load});
  rest(10);
  std::uint64_t before = 0, flown = 0, after = 0;
  const auto revision = [&] { return session.previewer.viewpoint().camera().revision(); };
  session.window.steps.push_back({"note", [&](WalkedWindow&) { before = revision(); }});
  add(MouseMoved{{60, 60}});
  add(MouseChanged{MouseButton::right, true});
  add(KeyChanged{Key::w, true});
  rest(20);
  add(KeyChanged{Key::w, false});
  rest(5);
  session.window.steps.push_back({"note", [&](WalkedWindow&) { flown = revision(); }});
  rest(20);
  session.window.steps.push_back({"note", [&](WalkedWindow&) { after = revision(); }});
  add_close(session.window);
  session.run();
  note(session.window);
  EXPECT_GT(flown, before + 5) << "it flew";
  EXPECT_EQ(after, flown) << "and stopped";
}

}  // namespace
}  // namespace asos::test::random_walk_test
