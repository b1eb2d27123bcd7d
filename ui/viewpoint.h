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

/// From where the open scene is seen, and in a picture of which size: the width and height of the
/// render settings. All members are for one thread.
class Viewpoint {
 public:
  /// Both must outlive it; of the settings it sets the picture's size only.
  Viewpoint(const OpenScene& scene, RenderSettings& settings);

  [[nodiscard]] OrbitCamera& camera() { return camera_; }
  [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
  /// Takes over the scene's camera `index`; -1: the view that frames everything.
  void choose_camera(int index);
  /// The scene's camera that was taken over last; -1: another one.
  [[nodiscard]] int chosen_camera() const { return chosen_camera_; }
  /// Whether the camera has been moved since then.
  [[nodiscard]] bool left_chosen() const { return camera_.revision() != chosen_revision_; }
  /// Goes with the chosen camera where the scene moves it and nobody else has. Call once or more a
  /// frame.
  void follow_chosen();
  /// Takes over a camera and orbits what it looks at. `index`: see chosen_camera. Only with a
  /// scene.
  void take_over(const Camera& of_file, int index = -1);
  /// Whether the camera's near and far planes cut the scene: the camera stays the chosen one.
  void set_planes(bool on);
  /// Looks at the same point from one side of the scene, as far away as before; what filled the
  /// picture fills it again.
  enum class Side { front, back, right, left, top, bottom };
  void look_from(Side side);
  /// Keeps the direction and moves so that the whole scene fills the picture; orbits the scene's
  /// middle from then on. Until the camera is moved, the scene fills pictures of other shapes, too.
  void frame_all();

  /// Steps back where everything is framed, until it stays in the picture while the camera turns
  /// about the vertical through the pivot.
  void make_room_to_turn();

  /// Asks for a picture of this size. The first one counts at once, later ones when the size has
  /// been still for a moment. Sizes without area (a minimised window) are ignored.
  void set_picture_size(int width, int height, double now_seconds);
  /// Sets the size that was asked for, once it has been still. Call once or more a frame.
  void settle_size(double now_seconds);
  /// When that will be, in seconds from now; none: the size has settled.
  [[nodiscard]] std::optional<double> seconds_to_settle(double now_seconds) const;
  /// Whether the picture's size is known.
  [[nodiscard]] bool sized() const { return sized_; }

  /// The camera's view in a picture of the present size. Only with a scene.
  [[nodiscard]] View view() const;
  /// The hit seen at (x, y), in pixels; not valid where that is the background.
  [[nodiscard]] Hit seen_at(double x, double y) const;
  /// Focuses the camera's lens on what the picture shows at (x, y), in pixels; not on background.
  void focus_at(double x, double y);
  /// Orbits about what the picture shows at (x, y), in pixels, from now on.
  void set_pivot_at(double x, double y);

  /// The state that undo restores.
  struct State {
    OrbitCamera camera;
    int chosen_camera = -1;
    std::uint64_t chosen_revision = 0;
    std::uint64_t framing = 0;  ///< the framing that the camera still shows; 0: none
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
  /// Takes over a camera that frames the scene from where `camera` looks from.
  void frame(const Camera& camera);
  /// Frames again, in a picture of another shape: the same framing.
  void frame_again();
  [[nodiscard]] std::uint64_t framing() const {
    return camera_.revision() == framed_revision_ ? framing_ : 0;
  }

  const OpenScene& scene_;
  RenderSettings& settings_;
  OrbitCamera camera_;
  int chosen_camera_ = -1;
  std::uint64_t chosen_revision_ = 0;  // of the camera, when it was taken over
  glm::dmat4 chosen_placed_{1.0};      // where it was then
  std::uint64_t framings_ = 0;         // counts them
  std::uint64_t framing_ = 0;          // the last one
  std::uint64_t framed_revision_ = 0;  // of the camera, when the scene was framed last
  bool sized_ = false;
  std::optional<PendingSize> pending_size_;
};

}  // namespace asos::ui
