#include "tests/ui/walker.h"

#include "tests/ui/control_parts.h"
#include "tests/ui/sliding_file.h"
#include "tests/ui/test_scenes.h"

#include <fmt/format.h>

#include <chrono>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace asos::test {
using namespace ui;

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
    Light light{.position = {0, 1, 2}, .radius = 0.2};
    scene.lights.assign(2, light);
    scene.lights[1].type = Light::Type::directional;
  }
  return scene;
}

std::vector<Walker::Step> Walker::next(Session& session) {
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

Walker::Step& Walker::named(std::string action) {
  steps_.push_back({std::move(action), [](WalkedWindow&) {}});
  return steps_.back();
}

void Walker::put(const std::string& action, const InputEvent& event) {
  named(action).run = [event](WalkedWindow& window) { window.add(event); };
}

void Walker::pause(const std::string& action, unsigned steps) {
  for (unsigned i = 0; i < steps; ++i) named(action);
}

void Walker::open() {
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

void Walker::fly() {
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

// Plays, pauses, seeks or steps the scene's animation, if it has one.
void Walker::play() {
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

void Walker::save() {
  if (below(2) == 0)
    return put("save", KeyChanged{Key::p, true}), put("save", KeyChanged{Key::p, false});
  const bool exr = below(2) == 0;
  const glm::ivec2 size(1 + below(200), 1 + below(150));
  const auto what = static_cast<SaveChoice::What>(below(3));
  named("save a picture").run = [=, this, &s = *session_](WalkedWindow&) {
    SaveChoice& choice = s.content->state().save;
    choice.what = what;
    choice.exr = exr;
    choice.size = size;
    choice.stem = folder_ + "/walk";
    choice.show = false;
    choice.asked = true;
  };
}

void Walker::press_key() {
  const Key key = static_cast<Key>(1 + below(static_cast<unsigned>(Key::count) - 1));
  const std::string action = fmt::format("key {}", static_cast<int>(key));
  put(action, KeyChanged{key, true});
  if (below(8) != 0) put(action, KeyChanged{key, false});
}

void Walker::resize() {
  const bool minimised = below(4) == 0;
  // Some windows are wide enough for the whole bar under the picture.
  const bool wide = below(6) == 0;
  const glm::ivec2 size(40 + static_cast<int>(below(400)) + (wide ? 700 : 0),
                        40 + static_cast<int>(below(300)) + (wide ? 250 : 0));
  if (minimised) {
    named("minimise").run = [](WalkedWindow& window) { window.resize({0, 0}); };
    pause("minimised", below(3));
  }
  named("resize").run = [size](WalkedWindow& window) { window.resize(size); };
}

void Walker::drag() {
  // Buttons go down and up anywhere, with moves between.
  const auto button = static_cast<MouseButton>(below(3));
  put("drag", MouseMoved{anywhere()});
  put("drag", MouseChanged{button, true});
  for (unsigned moves = 1 + below(3); moves > 0; --moves) put("drag", MouseMoved{anywhere()});
  if (below(6) != 0) put("drag", MouseChanged{button, false});
}

// Uses a random control from the table, if it is shown; of several with the same name, any.
void Walker::use_control() {
  auto at = parts.begin();
  std::advance(at, below(static_cast<unsigned>(parts.size())));
  const std::string head = at->first;
  // A size so large that the walk would not end.
  if (head == "Size" || head == "Width (px)" || head == "Height (px)") return rest();
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

}  // namespace asos::test
