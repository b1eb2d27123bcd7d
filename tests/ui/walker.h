#pragma once

#include "renderer/gltf/load.h"
#include "tests/ui/walked_window.h"
#include "ui/window_content.h"
#include "ui/window_loop.h"

#include <glm/glm.hpp>

#include <atomic>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace asos::test {
using namespace ui;

/// Test scenes; some take a moment to load.
[[nodiscard]] Result<Scene> load_some(const SceneSource& asked);

/// A window with its model, from opening to closing.
struct Session {
  Session()
      : window({360, 240}),
        previewer({load_some, [this] { woken = true; }}, small_settings()),
        content(std::move(*WindowContent::make(previewer))) {
    window.seconds_per_frame = 0.02;  // slower than the frame interval
    window.give_up = [this] { content->state().leaving.quit = true; };
  }
  static RenderSettings small_settings() { return {.asos = {.max_level = 2}, .threads = 2}; }
  void run() {
    WindowLoop(window, previewer, *content, {woken, [this] { return window.now_seconds(); }}).run();
  }

  std::atomic<bool> woken = false;
  WalkedWindow window;
  Previewer previewer;
  std::unique_ptr<WindowContent> content;
};

/// Turns random numbers into actions of one or several steps.
class Walker {
 public:
  using Step = WalkedWindow::Step;

  Walker(unsigned seed, std::string folder) : random_(seed), folder_(std::move(folder)) {}

  /// The steps of the next action. `session` must outlive them.
  std::vector<Step> next(Session& session);
  bool closes() { return below(60) == 0; }

 private:
  unsigned below(unsigned count) { return static_cast<unsigned>(random_()) % count; }
  float share() { return static_cast<float>(below(1001)) / 1000.0f; }
  glm::vec2 anywhere() { return glm::vec2(400.0f, 300.0f) * glm::vec2(share(), share()); }

  Step& named(std::string action);
  void put(const std::string& action, const InputEvent& event);
  void pause(const std::string& action, unsigned steps);

  void open();
  void fly();
  void play();
  void save();
  void press_key();
  void resize();
  void rest() { pause("rest", 5 + below(60)); }
  void drag();
  void use_control();

  std::mt19937 random_;
  std::string folder_;
  Session* session_ = nullptr;
  std::vector<Step> steps_;
};

}  // namespace asos::test
