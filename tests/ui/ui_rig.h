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
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asos::test {
using namespace ui;

/// The window's default display transform.
inline const DisplayTransform usual_display = DisplaySettings{}.transform();

/// The window's content in a context in memory, with a clock, a mouse and a keyboard that the test
/// controls. Opens nothing by itself. It starts in a user's initial state: the panel's tab
/// Antialias, and the bar under the picture. With the environment variable ASOS_SLOW_FRAMES each
/// frame takes until the render is finished, at most half a second: the order of events on a
/// machine that is busy in the window's thread.
class UiRig {
 public:
  /// The sky of scenes that set none: one colour behind all of them, or their default, as in the
  /// program.
  enum class Skies { neutral, usual };
  explicit UiRig(LoadFunction load, glm::ivec2 size = {640, 400}, float content_scale = 1.0f,
                 Skies skies = Skies::neutral);

  /// Size of a window with a bar whose picture is as large as in a window of size `size` without
  /// one.
  [[nodiscard]] static glm::ivec2 with_bar(glm::ivec2 size);

  Previewer& previewer() { return *previewer_; }
  WindowContent& content() { return *content_; }
  UiState& state() { return content_->state(); }
  InputQueue& input() { return content_->input(); }
  const std::map<std::string, Controls::Placed>& controls() { return content_->controls().all(); }
  OpenScene& scene() { return previewer_->scene(); }
  SceneEdits& edits() { return previewer_->edits(); }
  RenderSettings& settings() { return previewer_->edits().settings(); }
  Refinement& refinement() { return previewer_->refinement(); }
  Viewpoint& viewpoint() { return previewer_->viewpoint(); }
  OrbitCamera& camera() { return previewer_->viewpoint().camera(); }
  PreviewRender& render() { return previewer_->render(); }
  const Film& film() { return previewer_->render().film(); }

  /// Opens a scene and draws frames until it is shown; returns false if it cannot be opened.
  [[nodiscard]] bool opens(const std::string& source);

  void frame();
  /// Draws a frame at this time of the rig's clock, which never goes back.
  void frame_at(double now_seconds);
  /// Draws frames until `done`; returns false after `limit_seconds` of real time, ten times that
  /// under the sanitizers: long enough for a busy machine, so that only hanging code fails.
  [[nodiscard]] bool frames_until(const std::function<bool()>& done, double limit_seconds = 600.0);
  /// Draws only the frames that are due, like the window; the rig's time jumps from one to the
  /// next. Returns true once none is due any more, false after `limit_seconds` of that time.
  [[nodiscard]] bool sleeps(double limit_seconds = 36000.0);
  /// Draws frames until the render is finished and displayed and all input is processed, and stays
  /// so for three more frames: the first frame after a change may lay out the picture anew.
  [[nodiscard]] bool settle();
  void resize(glm::ivec2 size);

  void move_to(glm::vec2 position);
  void press(MouseButton button);
  void release(MouseButton button);
  void drag(glm::vec2 from, glm::vec2 to, MouseButton button = MouseButton::left);
  void wheel(glm::vec2 at, float steps);
  /// Waits long enough that the next click does not make a double click.
  void rest();
  void key(Key key);
  void chord(Key modifier, Key key);
  void type(const std::string& ascii);
  /// Fails the test if the control does not exist; opens its tab and scrolls the panel to it, like
  /// a user.
  Controls::Placed control(const std::string& name);
  void click(const std::string& name);
  /// Clicks controls one after the other, and draws a frame after each.
  void click_each(std::initializer_list<const char*> names);
  /// Opens a section of the panel if it is folded.
  void unfold(const std::string& section);

  /// In blind mode, which is the default, frames are laid out but not drawn: drawing takes most of
  /// software OpenGL's time. Saved pictures of the window are wrong then.
  void set_blind(bool blind) { blind_ = blind; }
  /// Framebuffer pixels are this number of window pixels wide and high. With fewer of them pictures
  /// are rendered faster, for tests that do not check them.
  void set_pixel_size(int pixel_size) { pixel_size_ = pixel_size; }
  [[nodiscard]] int pixel_size() const { return pixel_size_; }
  /// The framebuffer's content, row-major from the top left; a blind window draws one more frame
  /// for it.
  [[nodiscard]] std::vector<glm::u8vec3> pixels();
  [[nodiscard]] glm::ivec2 size() const { return size_; }

 private:
  void run_input();
  void draw();
  void linger() const;
  void open_tab_of(const std::string& name);
  [[nodiscard]] static bool of_bar(const std::string& name);

  std::unique_ptr<OsmesaContext> context_;
  std::unique_ptr<Previewer> previewer_;
  std::unique_ptr<WindowContent> content_;
  glm::ivec2 size_;
  float content_scale_;
  bool lingers_;
  double now_seconds_ = 0.0, pressed_seconds_ = 0.0;
  DrawSchedule schedule_;
  std::atomic<bool> woken_ = false;
  bool blind_ = true;
  int pixel_size_ = 1;
};

}  // namespace asos::test
