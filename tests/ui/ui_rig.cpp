#include "tests/ui/ui_rig.h"

#include "tests/support/sanitized.h"
#include "ui/gl/gl.h"
#include "ui/theme.h"
#include "ui/window_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>

namespace asos::test {
using namespace ui;

namespace {

template <typename T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message());
  return std::move(*result);
}

RenderSettings small_settings() {
  return {.asos = {.max_level = 2}, .threads = 1};
}

// A test waits for the render's thread, and laying out a frame takes about a millisecond. Pauses
// keep waiting from taking as much processor time as rendering. A render takes many frames; other
// jobs end within a few.
void pause_for_other_threads(bool rendering) {
  std::this_thread::sleep_for(std::chrono::milliseconds(rendering ? 12 : 4));
}

}  // namespace

UiRig::UiRig(LoadFunction load, glm::ivec2 size, float content_scale, Skies skies)
    : context_(value_or_throw(OsmesaContext::make(size.x, size.y))),
      previewer_(std::make_unique<Previewer>(
          Previewer::Hooks{std::move(load), [this] { woken_ = true; }}, small_settings())),
      content_(value_or_throw(WindowContent::make(*previewer_))),
      size_(size),
      content_scale_(content_scale),
      lingers_(std::getenv("ASOS_SLOW_FRAMES") != nullptr) {
  if (skies == Skies::neutral) previewer_->edits().keep_first({true, true, true});
}

glm::ivec2 UiRig::with_bar(glm::ivec2 size) {
  constexpr float em = theme::text_pixels;
  const float picture = WindowLayout::of(size, em, true, false).picture.size.y;
  for (const float bar_em : {theme::bar_height_em, theme::compact_bar_height_em}) {
    const glm::ivec2 larger(size.x, size.y + static_cast<int>(std::round(bar_em * em)));
    if (WindowLayout::of(larger, em, true, true).picture.size.y == picture) return larger;
  }
  return size;
}

void UiRig::frame() {
  now_seconds_ += 1.0 / 60.0;
  draw();
}

void UiRig::draw() {
  const glm::ivec2 framebuffer = glm::max(size_ / pixel_size_, glm::min(size_, 1));
  content_->draw({size_, framebuffer, content_scale_ / static_cast<float>(pixel_size_),
                  now_seconds_, !blind_});
  // A window finishes its frames when it presents them. Without this the driver keeps the uploads
  // of all frames.
  gl::glFinish();
  if (lingers_) linger();
}

// Lets a short render end within the frame, as with a slow graphics driver.
void UiRig::linger() const {
  constexpr int most_waits = 500;
  const PreviewRender& render = previewer_->render();
  for (int i = 0; i < most_waits && render.progress().running && render.final_share() < 1.0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void UiRig::frame_at(double now_seconds) {
  now_seconds_ = std::max(now_seconds_, now_seconds);
  draw();
}

bool UiRig::frames_until(const std::function<bool()>& done, double limit_seconds) {
  if (sanitized) limit_seconds *= 10.0;
  const auto start = std::chrono::steady_clock::now();
  while (!done()) {
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() >
        limit_seconds) {
      return false;
    }
    frame();
    pause_for_other_threads(previewer_->render().progress().running);
  }
  return true;
}

bool UiRig::sleeps(double limit_seconds) {
  schedule_ = {};
  const double end = now_seconds_ + limit_seconds * (sanitized ? 10.0 : 1.0);
  while (now_seconds_ < end) {
    if (woken_.exchange(false)) schedule_.note_woken(false);
    if (!content_->input().empty()) schedule_.note_input();
    // No running work could end the sleep.
    const bool due = schedule_.due() != DrawSchedule::never;
    if (!due && !previewer_->render().progress().running) return true;
    if (due) {
      now_seconds_ = std::max(now_seconds_, schedule_.due());
      schedule_.begin_frame(now_seconds_);
      draw();
      schedule_.end_frame(now_seconds_, content_->seconds_to_redraw());
    }
    pause_for_other_threads(previewer_->render().progress().running);
  }
  return false;
}

bool UiRig::opens(const std::string& source) {
  const std::uint64_t before = scene().times_opened();
  scene().open(source);
  return frames_until([&] { return scene().times_opened() > before || scene().error(); }) &&
         !scene().error();
}

bool UiRig::settle() {
  // A frame may lay the picture out anew after a render that finished within the frame before.
  constexpr int still_frames = 3;
  int still = 0;
  return frames_until([&] {
    const bool settled = content_->input().empty() && !previewer_->scene().loading() &&
                         previewer_->render().progress().finished &&
                         !previewer_->seconds_to_update(now_seconds_);
    still = settled ? still + 1 : 0;
    return still > still_frames;
  });
}

void UiRig::resize(glm::ivec2 size) {
  size_ = size;
  if (size.x > 0 && size.y > 0 && !context_->resize(size.x, size.y)) {
    throw std::runtime_error("OSMesa refused the size");
  }
  frame();
}

void UiRig::run_input() {
  while (!content_->input().empty()) frame();
  frame();
}

void UiRig::move_to(glm::vec2 position) {
  content_->input().add(MouseMoved{position});
  run_input();
}

void UiRig::rest() {
  constexpr double seconds_between_clicks = 0.4;
  if (now_seconds_ < pressed_seconds_ + seconds_between_clicks)
    frame_at(pressed_seconds_ + seconds_between_clicks);
}

void UiRig::press(MouseButton button) {
  content_->input().add(MouseChanged{button, true});
  run_input();
  pressed_seconds_ = now_seconds_;
}

void UiRig::release(MouseButton button) {
  content_->input().add(MouseChanged{button, false});
  run_input();
}

void UiRig::drag(glm::vec2 from, glm::vec2 to, MouseButton button) {
  move_to(from);
  press(button);
  constexpr int steps = 4;
  for (int i = 1; i <= steps; ++i) {
    move_to(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps)));
  }
  release(button);
}

void UiRig::wheel(glm::vec2 at, float steps) {
  move_to(at);
  content_->input().add(WheelTurned{{0.0f, steps}});
  run_input();
}

void UiRig::key(Key key) {
  content_->input().add(KeyChanged{key, true});
  content_->input().add(KeyChanged{key, false});
  run_input();
}

void UiRig::chord(Key modifier, Key key_pressed) {
  content_->input().add(KeyChanged{modifier, true});
  content_->input().add(KeyChanged{key_pressed, true});
  content_->input().add(KeyChanged{key_pressed, false});
  content_->input().add(KeyChanged{modifier, false});
  run_input();
}

void UiRig::type(const std::string& ascii) {
  for (const char c : ascii) content_->input().add(TextTyped{static_cast<char32_t>(c)});
  run_input();
}

namespace {

constexpr const char* over_picture[] = {"Card", "Pixel panel", "Map legend"};

bool holds(const std::map<std::string, Controls::Placed>& all, const char* window,
           const Controls::Placed& control) {
  const auto found = all.find(window);
  return found != all.end() && glm::all(glm::greaterThanEqual(control.lo, found->second.lo)) &&
         glm::all(glm::lessThanEqual(control.hi, found->second.hi));
}

// Whether a control belongs to the pixel panel.
bool of_pixel(const std::string& name) {
  return name == "Back" || name == "Show edges" || name == "Subdivision" || name == "Levels" ||
         name.starts_with("Pyray/");
}

}  // namespace

// The bar and its lists are never scrolled.
bool UiRig::of_bar(const std::string& name) {
  const std::string head = name.substr(0, name.find('/'));
  return head == "Layer" || head.ends_with(" in bar");
}

void UiRig::open_tab_of(const std::string& name) {
  const auto& all = content_->controls().all();
  for (const char* tab : {"Antialias", "Scene", "Measure"}) {
    const std::string button = std::string("Tab/") + tab;
    if (all.contains(name) || !all.contains(button)) return;
    move_to(control(button).centre());
    press(MouseButton::left);
    release(MouseButton::left);
    for (int i = 0; i < 3; ++i) frame();
  }
}

Controls::Placed UiRig::control(const std::string& name) {
  const auto& all = content_->controls().all();
  if (!all.contains(name)) open_tab_of(name);
  constexpr int most_turns = 100;
  for (int turn = 0;; ++turn) {
    const auto found = all.find(name);
    if (found == all.end()) throw std::runtime_error("no control named " + name);
    const Controls::Placed at = found->second;
    if (of_bar(name)) return at;
    const WindowRect& panel = content_->layout().panel;
    const auto height = static_cast<float>(size_.y);
    // Controls over the picture need no scrolling.
    const bool over = std::any_of(std::begin(over_picture), std::end(over_picture),
                                  [&](const char* window) { return holds(all, window, at); });
    // The pixel panel is scrolled if there is little room for it.
    const auto pixel = all.find("Pixel panel");
    if (pixel != all.end() && of_pixel(name) && turn < most_turns &&
        (at.lo.y < pixel->second.lo.y || at.hi.y > pixel->second.hi.y)) {
      wheel(pixel->second.centre(), at.lo.y < pixel->second.lo.y ? 1.0f : -1.0f);
      continue;
    }
    const bool in_panel = at.centre().x > panel.lo.x && panel.size.x > 0.0f && !over;
    const bool above = at.lo.y<(in_panel ? panel.lo.y : 0.0f), below = at.hi.y> height;
    if ((!above && !below) || turn == most_turns) return at;
    // The panel is longer than the window: turn the wheel over it, like a user.
    wheel(panel.lo + glm::vec2(panel.size.x - 20.0f, 0.5f * panel.size.y), above ? 1.0f : -1.0f);
  }
}

void UiRig::click(const std::string& name) {
  // Tries again if the control has moved meanwhile: results of other threads move rows. The second
  // look turns no wheel, as this would leave the pointer where the wheel was turned.
  const auto& all = content_->controls().all();
  constexpr int tries = 10;
  for (int i = 0; i < tries; ++i) {
    const glm::vec2 aim = control(name).centre();
    move_to(aim);
    const auto now = all.find(name);
    if (now != all.end() && now->second.centre() == aim) break;
  }
  press(MouseButton::left);
  release(MouseButton::left);
}

void UiRig::click_each(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    click(name);
    frame();
  }
}

void UiRig::unfold(const std::string& section) {
  const std::string name = "section/" + section;
  constexpr int tries = 5;  // a row that moved between aiming and clicking is missed
  for (int i = 0; i < tries && control(name).words != "open"; ++i) {
    click(name);
    frame();  // its rows appear in the next frame
  }
  EXPECT_EQ(control(name).words, "open") << section;
}

std::vector<glm::u8vec3> UiRig::pixels() {
  if (std::exchange(blind_, false)) {
    frame();
    blind_ = true;
  }
  const std::size_t width = static_cast<std::size_t>(size_.x);
  const std::size_t height = static_cast<std::size_t>(size_.y);
  EXPECT_EQ(pixel_size_, 1);
  std::vector<glm::u8vec3> pixels(width * height);
  gl::glPixelStorei(GL_PACK_ALIGNMENT, 1);
  gl::glReadPixels(0, 0, size_.x, size_.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  for (std::size_t y = 0; y < height / 2; ++y) {
    std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * width),
                     pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                     pixels.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * width));
  }
  return pixels;
}

}  // namespace asos::test
