#pragma once

#include "renderer/geometry/view.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"
#include "ui/open_scene.h"
#include "ui/orbit_camera.h"

#include <cstdint>
#include <optional>

namespace asos::ui {

/// The camera of the open scene, and the size of its picture (width and height of the render
/// settings). All members must be called from one thread.
class Viewpoint {
 public:
  /// `scene` and `settings` must outlive the object, which changes only the size in `settings`.
  Viewpoint(const OpenScene& scene, RenderSettings& settings);

  [[nodiscard]] OrbitCamera& camera() { return camera_; }
  [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
  /// Switches to the scene's camera `index`; -1: a view that frames the whole scene.
  void choose_camera(int index);
  /// Index of the scene's camera that was chosen last; -1: another view.
  [[nodiscard]] int chosen_camera() const { return chosen_camera_; }
  /// Whether the camera has been moved since it was chosen.
  [[nodiscard]] bool left_chosen() const { return camera_.revision() != chosen_revision_; }
  /// Follows the animation of the chosen camera unless the user has moved the view. Call at least
  /// once a frame.
  void follow_chosen();
  /// Switches to a camera with the pivot at its subject. `index`: see chosen_camera. Requires a
  /// scene.
  void take_over(const Camera& of_file, int index = -1);
  /// Sets whether the camera's near and far planes clip the scene; the camera stays the chosen one.
  void set_planes(bool on);
  /// Looks at the pivot from one side of the scene, at the same distance; a scene that filled the
  /// picture fills it again.
  enum class Side { front, back, right, left, top, bottom };
  void look_from(Side side);
  /// Keeps the direction and moves the camera so that the whole scene fills the picture; the pivot
  /// becomes the scene's centre. Until the camera is moved, this framing also follows changes of
  /// the aspect ratio.
  void frame_all();

  /// The same for a part of the scene, which is not followed.
  void frame_box(const Box& box);

  /// If the whole scene is framed, moves back so far that it stays in the picture while the camera
  /// turns about the vertical axis through the pivot.
  void make_room_to_turn();

  /// Requests a picture size. The first one applies at once, later ones when the size has been
  /// still for a moment. Sizes without area (a minimised window) are ignored.
  void set_picture_size(int width, int height, double now_seconds);
  /// Applies the requested size once it has been still. Call at least once a frame.
  void settle_size(double now_seconds);
  /// Seconds until the requested size applies; none: it is applied already.
  [[nodiscard]] std::optional<double> seconds_to_settle(double now_seconds) const;
  /// Whether the picture's size is known.
  [[nodiscard]] bool sized() const { return sized_; }

  /// The view of the camera in a picture of the current size. Requires a scene.
  [[nodiscard]] View view() const;
  /// The nearest hit at (x, y), in pixels, of a surface that is not blended away; invalid on the
  /// background.
  [[nodiscard]] Hit seen_at(double x, double y) const;
  /// Focuses the camera's lens on the surface at (x, y), in pixels; no effect on the background.
  void focus_at(double x, double y);
  /// Sets the pivot to the surface at (x, y), in pixels.
  void set_pivot_at(double x, double y);

  /// The state that undo restores.
  struct State {
    OrbitCamera camera;
    int chosen_camera = -1;
    std::uint64_t chosen_revision = 0;
    std::uint64_t framing = 0;  ///< number of the framing that the camera still shows; 0: none
  };
  [[nodiscard]] State state() const {
    return {camera_, chosen_camera_, chosen_revision_, framing()};
  }
  [[nodiscard]] bool same_as(const State& state) const;
  void restore(const State& state);

 private:
  struct PendingSize {
    int width, height;
    double since_seconds;
  };
  [[nodiscard]] double aspect_ratio() const;
  void turn_to(Side side);
  /// Sets a camera that frames the scene from the direction of `camera`.
  void frame(const Camera& camera);
  /// Repeats the framing for another aspect ratio.
  void frame_again();
  [[nodiscard]] std::uint64_t framing() const {
    return camera_.revision() == framed_revision_ ? framing_ : 0;
  }

  const OpenScene& scene_;
  RenderSettings& settings_;
  OrbitCamera camera_;
  int chosen_camera_ = -1;
  std::uint64_t chosen_revision_ = 0;  // camera revision when it was chosen
  glm::dmat4 chosen_placed_{1.0};      // its placement when it was chosen
  std::uint64_t framings_ = 0;         // number of framings so far
  std::uint64_t framing_ = 0;          // number of the last framing
  std::uint64_t framed_revision_ = 0;  // camera revision when the scene was framed last
  bool sized_ = false;
  std::optional<PendingSize> pending_size_;
};

}  // namespace asos::ui
