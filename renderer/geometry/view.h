#pragma once

#include "renderer/geometry/box.h"
#include "renderer/geometry/camera.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/half_space.h"
#include "renderer/geometry/lens.h"
#include "renderer/geometry/pixel_rect.h"
#include "renderer/geometry/ray.h"

#include <glm/glm.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace asos {

/// The radius of the ball around the origin that holds a box; infinite for an empty one. A view of
/// a world needs no more of its box.
[[nodiscard]] double radius_around_origin(const Box& box);

/// A picture of one pixel: the pyray from an apex through a parallelogram. A mirrored pyray is one.
struct PyrayPicture {
  bool perspective = true;
  glm::dvec3 apex{0.0};  ///< where rays are parallel: any point of the image plane
  /// From the apex to the parallelogram's corner, where `forward` is one unit ahead; parallel rays:
  /// one unit ahead of the corner.
  glm::dvec3 corner{0, 0, -1};
  glm::dvec3 right{1, 0, 0};  ///< its edges; square to `forward`
  glm::dvec3 down{0, -1, 0};
  glm::dvec3 forward{0, 0, -1};  ///< unit
  HalfSpace beyond;              ///< rays start where they enter it; those that do not meet nothing
};

/// A camera and the picture that it fills: makes eye rays and eye frames. The vertical extent is
/// the camera's; the horizontal one follows the picture's proportions. Pixel (0, 0) is at the top
/// left and its centre is (0.5, 0.5). `camera` is relative to World::origin. Thread-safe.
///
/// All that is to be seen lies within `scene_radius` of the origin. From a camera a thousand times
/// as far away rays start just before that: floats of the camera's size would lose the scene.
///
/// Rays run from the camera's near_depth to its far_depth, where the scene may lie beyond those.
///
/// With a lens, rays that start at a point of it pass the focus plane where the ray from its centre
/// does. Frames, and rays without such a point, are those of its centre. A lens whose focus is
/// automatic has none yet (focused_camera): such a view has no lens.
class View {
 public:
  View(const Camera& camera, int width, int height,
       double scene_radius = std::numeric_limits<double>::infinity());
  explicit View(const PyrayPicture& picture);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// How far from the eye, or from the image plane, rays start: 0 but for far cameras and mirrors.
  [[nodiscard]] double start() const { return start_; }

  /// The half-space ahead of the near plane, or of an orthographic view's image plane; none where
  /// rays start elsewhere.
  [[nodiscard]] std::optional<HalfSpace> ahead() const {
    if (beyond_ || (near_ == 0.0 && (perspective_ || start_ > 0.0))) return std::nullopt;
    return HalfSpace::through(eye_ + near_ * forward_, forward_);
  }
  /// The half-space in front of the far plane; none where there is no such plane.
  [[nodiscard]] std::optional<HalfSpace> before() const {
    if (std::isinf(far_)) return std::nullopt;
    return HalfSpace::through(eye_ + far_ * forward_, -forward_);
  }

  /// The depths of the near and the far plane; 0 and infinite where there is none.
  [[nodiscard]] double near_depth() const { return near_; }
  [[nodiscard]] double far_depth() const { return far_; }

  /// The eye ray through a point of the picture, in pixels; unit direction.
  [[nodiscard]] Ray ray(double x, double y) const;

  /// The same through many points; `rays` is as long as `points`.
  void rays(std::span<const glm::dvec2> points, std::span<Ray> rays) const;

  /// Whether depth blurs.
  [[nodiscard]] bool has_lens() const { return lens_.blurs(); }
  /// A lens whose focus is known; a pinhole where depth does not blur.
  [[nodiscard]] const Lens& lens() const { return lens_; }
  /// The ray through a point of the picture that starts at a point of the lens.
  [[nodiscard]] Ray ray(double x, double y, const ExposurePoint& exposure) const;
  /// Radius of the circle of confusion at a depth, in pixels; infinite depths are allowed.
  [[nodiscard]] double confusion(double depth) const {
    return confusion_ * std::abs(1.0 / depth - 1.0 / lens_.focus.value_or(1.0));
  }
  /// How much the radius changes over a difference of inverse depths.
  [[nodiscard]] double confusion_of_nearness(double difference) const {
    return confusion_ * difference;
  }
  /// The depth in front of the focus plane with a circle of confusion of this radius.
  [[nodiscard]] double depth_before_focus(double radius) const {
    return 1.0 / (1.0 / lens_.focus.value_or(1.0) + radius / confusion_);
  }
  /// The depth of a point of a ray, along the view axis.
  [[nodiscard]] double depth(const Ray& ray, float t) const {
    return glm::dot(forward_, glm::dvec3(ray.origin) - eye_) +
           static_cast<double>(t) * glm::dot(forward_, glm::dvec3(ray.direction));
  }

  /// The frame of the pyray through a rectangle of the picture, in pixels: (u, v) runs from 0 to 1
  /// from its top left to its bottom right corner.
  [[nodiscard]] Frame frame(double x, double y, double width, double height) const;

 private:
  void set_planes(const Camera& camera, double scene_radius);
  /// Cuts a ray off at the near and the far plane.
  void cut(Ray& ray, glm::dvec3 direction) const;
  [[nodiscard]] bool cuts() const { return near_ > 0.0 || !std::isinf(far_); }

  bool perspective_;
  glm::dvec3 eye_;          // perspective: the apex; orthographic: a point of the image plane
  glm::dvec3 corner_;       // from eye_ to the picture's top left corner, one unit ahead
  glm::dvec3 pixel_right_;  // one pixel to the right, in world units
  glm::dvec3 pixel_down_;
  glm::dvec3 forward_;  // unit
  int width_;
  int height_;
  double start_ = 0.0;
  double near_ = 0.0;
  double far_ = std::numeric_limits<double>::infinity();
  std::optional<HalfSpace> beyond_;
  Lens lens_;
  glm::dvec3 lens_right_{0.0}, lens_up_{0.0};  // unit
  double confusion_ = 0.0;  // the lens' radius, in pixels of the plane one unit ahead
};

}  // namespace asos
