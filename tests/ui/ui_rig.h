#pragma once

#include "renderer/film/film.h"
#include "tests/ui/osmesa_context.h"
#include "ui/display_settings.h"
#include "ui/draw_schedule.h"
#include "ui/previewer.h"
#include "ui/window_content.h"

#include <glm/glm.hpp>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asos::test {
using namespace ui;

/// How the window shows pictures unless it is told otherwise.
inline const DisplayTransform usual_display = DisplaySettings{}.transform();

/// The window's content in a context in memory, with a clock, a mouse and a keyboard that a test
/// moves. Opens nothing by itself. It shows what a user sees at first: the panel's tab Antialias,
/// and the bar under the picture.
class UiRig {
 public:
  /// Which sky scenes have that do not ask for one: one colour behind all of them, or their usual
  /// one, as in the program.
  enum class Skies { neutral, usual };
  explicit UiRig(LoadFunction load, glm::ivec2 size = {640, 400}, float content_scale = 1.0f,
                 Skies skies = Skies::neutral);

  /// A window with a bar whose picture is as large as that of one of this size without it.
  [[nodiscard]] static glm::ivec2 with_bar(glm::ivec2 size);

  Previewer& previewer() { return *previewer_; }
  WindowContent& content() { return *content_; }

  void frame();
  /// A frame at this time of the rig's clock, which never falls.
  void frame_at(double now_seconds);
  /// Draws frames until `done`; false after `limit_seconds` of real time, ten times that under the
  /// sanitizers: long enough for a busy machine, so that only what hangs ends so.
  [[nodiscard]] bool frames_until(const std::function<bool()>& done, double limit_seconds = 600.0);
  /// Draws as the window does: only frames that are due. The rig's time jumps from one to the next.
  /// True once none is due any more; false after `limit_seconds` of that time.
  [[nodiscard]] bool sleeps(double limit_seconds = 600.0);
  /// Frames until the render is finished and shown and the input is used up.
  [[nodiscard]] bool settle();
  void resize(glm::ivec2 size);

  void move_to(glm::vec2 position);
  void press(MouseButton button);
  void release(MouseButton button);
  void drag(glm::vec2 from, glm::vec2 to, MouseButton button = MouseButton::left);
  void wheel(glm::vec2 at, float steps);
  /// Long enough for the next click to be no second one of two.
  void rest();
  void key(Key key);
  void chord(Key modifier, Key key);
  void type(const std::string& ascii);
  /// Fails the test where the control is not there; opens its tab and scrolls the panel to it, as a
  /// person would.
  Controls::Placed control(const std::string& name);
  void click(const std::string& name);
  /// Sees to it that a section of the panel is open.
  void unfold(const std::string& section);

  /// Frames are laid out but not drawn, which software OpenGL takes long for, unless a test says
  /// otherwise: what a picture of the window saves is wrong then.
  void set_blind(bool blind) { blind_ = blind; }
  /// The framebuffer has a pixel for so many of the window's, across and down: the fewer, the
  /// sooner a picture is rendered and shown, for tests that look at neither.
  void set_pixel_size(int pixel_size) { pixel_size_ = pixel_size; }
  [[nodiscard]] int pixel_size() const { return pixel_size_; }
  /// What the framebuffer shows, row-major from the top left; of a blind window after one more
  /// frame.
  [[nodiscard]] std::vector<glm::u8vec3> pixels();
  [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
  void run_input();
  void draw();
  void open_tab_of(const std::string& name);
  [[nodiscard]] static bool of_bar(const std::string& name);

  std::unique_ptr<OsmesaContext> context_;
  std::unique_ptr<Previewer> previewer_;
  std::unique_ptr<WindowContent> content_;
  glm::ivec2 size_;
  float content_scale_;
  double now_seconds_ = 0.0, pressed_seconds_ = 0.0;
  DrawSchedule schedule_;
  std::atomic<bool> woken_ = false;
  bool blind_ = true;
  int pixel_size_ = 1;
};

}  // namespace asos::test
