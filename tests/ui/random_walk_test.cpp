#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/control_parts.h"
#include "tests/ui/sliding_file.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/walked_window.h"
#include "ui/window_loop.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

// Somebody who clicks, drags, types, flies, resizes, plays, saves, opens scenes and closes the
// window without waiting for anything, through the loop that draws the real window; and what has to
// hold then. What is done follows from a seed alone. Under the sanitizers the walk is longer, and
// there are no reports.

namespace asos::test::random_walk_test {
namespace {

constexpr int actions = sanitized ? 2000 : 1000;

/// Scenes of several sorts, some of which take a moment to load, and some of which do not.
Result<Scene> load_some(const SceneSource& asked) {
  const std::string& source = asked.path;
  if (source.find("slow") != std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  if (source.find("bad") != std::string::npos) return unexpected(Error{source, "is broken"});
  if (source.find("throws") != std::string::npos) throw std::runtime_error("thrown");
  if (source.find("grating") != std::string::npos) return grating(source);
  if (source.find("moving") != std::string::npos) return with_rig(sliding());
  Scene scene = two_triangles({0.5f, 0.6f, 0.9f}, source);
  scene.materials[0].unlit = false;
  if (source.find("mirror") != std::string::npos) {
    scene.materials[0].metallic = 1.0f;
    scene.materials[0].roughness = 0.2f;
  }
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

/// A window with all behind it, from its opening to its end.
struct Session {
  Session()
      : window({360, 240}),
        previewer({load_some, [this] { woken = true; }}, small_settings()),
        content(std::move(*WindowContent::make(previewer))) {
    window.seconds_per_frame = 0.02;  // longer than there is time for one
    window.give_up = [this] { content->state().leaving.quit = true; };
  }
  static RenderSettings small_settings() {
    RenderSettings settings;
    settings.asos.max_level = 2;
    settings.threads = 2;
    return settings;
  }
  void run() {
    WindowLoop(window, previewer, *content, {woken, [this] { return window.now_seconds(); }}).run();
  }

  std::atomic<bool> woken = false;
  WalkedWindow window;
  Previewer previewer;
  std::unique_ptr<WindowContent> content;
};

/// Turns random numbers into actions, each of one or several steps.
class Walker {
 public:
  using Step = WalkedWindow::Step;

  Walker(unsigned seed, std::string folder) : random_(seed), folder_(std::move(folder)) {}

  /// The steps of the next action. `session` must outlive them.
  std::vector<Step> next(Session& session) {
    session_ = &session;
    steps_.clear();
    switch (below(24)) {
      case 0:
      case 1:
        open();
        break;
      case 2:
        named("reload").run = [&s = session](WalkedWindow&) { s.previewer.scene().reload(); };
        break;
      case 3:
      case 4:
        fly();
        break;
      case 5:
        put("wheel", WheelTurned{{0.0f, below(2) == 0 ? 1.0f : -1.0f}});
        break;
      case 6:
        play();
        break;
      case 7:
        save();
        break;
      case 8:
      case 9:
        press_key();
        break;
      case 10:
        put("type", TextTyped{static_cast<char32_t>("0123456789.-e"[below(13)])});
        break;
      case 11:
      case 12:
        resize();
        break;
      case 13:
        put("lose the focus", FocusLost{});
        break;
      case 14:
        rest();
        break;
      case 15:
      case 16:
      case 17:
      case 18:
      case 19:
        use_control();
        break;
      default:
        drag();
        break;
    }
    return std::exchange(steps_, {});
  }
  bool closes() { return below(60) == 0; }

 private:
  unsigned below(unsigned count) { return static_cast<unsigned>(random_()) % count; }
  float share() { return static_cast<float>(below(1001)) / 1000.0f; }
  glm::vec2 anywhere() { return glm::vec2(400.0f, 300.0f) * glm::vec2(share(), share()); }

  Step& named(std::string action) {
    steps_.push_back({std::move(action), [](WalkedWindow&) {}});
    return steps_.back();
  }
  void put(const std::string& action, const InputEvent& event) {
    named(action).run = [event](WalkedWindow& window) { window.add(event); };
  }
  void pause(const std::string& action, unsigned steps) {
    for (unsigned i = 0; i < steps; ++i) named(action);
  }

  void open() {
    constexpr const char* sources[] = {"plain",  "slow lit", "grating",    "bad",
                                       "lit",    "moving",   "slow bad",   "slow grating",
                                       "mirror", "throws",   "lit mirror", "gone.png",
                                       "empty",  "moving",   "slow moving"};
    const std::string source = sources[below(15)];
    if (below(3) == 0) {
      named("drop " + source).run = [source](WalkedWindow& window) {
        window.happened().dropped_files.push_back(source);
      };
    } else {
      named("open " + source).run = [source, &s = *session_](WalkedWindow&) {
        s.previewer.scene().open(source);
      };
    }
  }
  void fly() {
    constexpr Key ways[] = {Key::w, Key::a, Key::s, Key::d, Key::q, Key::e};
    const Key way = ways[below(6)];
    put("fly", MouseMoved{anywhere()});
    put("fly", MouseChanged{MouseButton::right, true});
    put("fly", KeyChanged{way, true});
    pause("fly", 1 + below(6));
    put("fly", MouseMoved{anywhere()});
    if (below(4) != 0) put("fly", KeyChanged{way, false});
    if (below(4) != 0) put("fly", MouseChanged{MouseButton::right, false});
  }
  // Whatever of it is there: the window, or what moves.
  void play() {
    const unsigned what = below(4);
    const double seconds = 2.0 * static_cast<double>(share());
    named("play").run = [what, seconds, &s = *session_](WalkedWindow&) {
      Playback& playback = s.previewer.playback();
      if (!playback.available()) return;
      if (what < 2) playback.set_playing(what == 0);
      if (what == 2) playback.seek(seconds);
      if (what == 3) playback.step(1);
    };
    pause("play", below(5));
  }
  void save() {
    if (below(2) == 0)
      return put("save", KeyChanged{Key::p, true}), put("save", KeyChanged{Key::p, false});
    const bool exr = below(2) == 0;
    const glm::ivec2 size(1 + below(200), 1 + below(150));
    const auto what = static_cast<SaveChoice::What>(below(3));
    named("save a picture").run = [=, this, &s = *session_](WalkedWindow&) {
      SaveChoice& choice = s.content->state().save;
      choice = {what, exr, size, folder_ + "/walk", false, true};
    };
  }
  void press_key() {
    const Key key = static_cast<Key>(1 + below(static_cast<unsigned>(Key::count) - 1));
    const std::string action = fmt::format("key {}", static_cast<int>(key));
    put(action, KeyChanged{key, true});
    if (below(8) != 0) put(action, KeyChanged{key, false});
  }
  void resize() {
    const bool minimised = below(4) == 0;
    const glm::ivec2 size(40 + static_cast<int>(below(400)), 40 + static_cast<int>(below(300)));
    if (minimised) {
      named("minimise").run = [](WalkedWindow& window) { window.resize({0, 0}); };
      pause("minimised", below(3));
    }
    named("resize").run = [size](WalkedWindow& window) { window.resize(size); };
  }
  void rest() { pause("rest", 5 + below(60)); }
  void drag() {
    // Buttons go down and up anywhere, with moves between.
    const auto button = static_cast<MouseButton>(below(3));
    put("drag", MouseMoved{anywhere()});
    put("drag", MouseChanged{button, true});
    for (unsigned moves = 1 + below(3); moves > 0; --moves) put("drag", MouseMoved{anywhere()});
    if (below(6) != 0) put("drag", MouseChanged{button, false});
  }
  // One of those that the table knows, where it is there; of several of a kind any.
  void use_control() {
    auto at = parts.begin();
    std::advance(at, below(static_cast<unsigned>(parts.size())));
    const std::string head = at->first;
    // As large as that no walk could end.
    if (head == "Pixels" || head == "Across" || head == "Down") return rest();
    const unsigned which = below(12);
    const glm::vec2 place(share(), 0.5f), to = anywhere();
    const bool moves = below(2) == 0;
    named("use " + head).run = [=, &s = *session_](WalkedWindow& window) {
      const auto& all = s.content->controls().all();
      std::vector<Controls::Placed> found;
      for (auto it = all.lower_bound(head); it != all.end() && it->first.starts_with(head); ++it)
        if (it->first.size() == head.size() || it->first[head.size()] == '/')
          found.push_back(it->second);
      if (found.empty()) return;
      const Controls::Placed& control = found[which % found.size()];
      window.add(MouseMoved{glm::mix(control.lo, control.hi, place)});
      window.add(MouseChanged{MouseButton::left, true});
      if (moves) window.add(MouseMoved{to});
      window.add(MouseChanged{MouseButton::left, false});
    };
  }

  std::mt19937 random_;
  std::string folder_;
  Session* session_ = nullptr;
  std::vector<Step> steps_;
};

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

  // Asked twice, whatever it might lose.
  static void add_close(WalkedWindow& window) {
    const auto ask = [](WalkedWindow& w) { w.happened().asked_to_close = true; };
    window.steps.push_back({"close", ask});
    // A minimised one, or one that loads, takes its time to hear it.
    window.idle = ask;
  }
  /// Reports, and keeps the most of all windows.
  void note(const WalkedWindow& window) {
    EXPECT_LE(window.most().frames, 1) << "frames were drawn though nothing was heard between them";
    frames += window.frames();
    if (window.most().wall_ms > slowest_wall.wall_ms) slowest_wall = window.most();
    if (window.most().processor_ms > slowest.processor_ms) slowest = window.most();
  }

  TemporaryFolder folder;
  WalkedWindow::Between slowest, slowest_wall;
  int frames = 0;
};

/// A quarter of the walk, so that none takes too long.
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

// After a walk, what is asked for next is done.
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
    // Everything is let go of, and put back.
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

// Frames that take longer than the time between them once left no moment to hear a key being let
// go: who flew, flew on for good.
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
