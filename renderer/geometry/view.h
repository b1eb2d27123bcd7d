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

/// Returns the radius of the ball around the origin that contains a box; infinite for an empty one.
/// A view of a world needs nothing else of its box.
[[nodiscard]] double radius_around_origin(const Box& box);

/// A picture of one pixel: the pyray from an apex through a parallelogram, such as a reflected
/// pyray.
struct PyrayPicture {
  bool perspective = true;
  glm::dvec3 apex{0.0};  ///< for parallel rays: any point of the image plane
  /// From the apex to the parallelogram's corner, at depth 1 along `forward`; for parallel rays, to
  /// the point one unit ahead of the corner.
  glm::dvec3 corner{0, 0, -1};
  glm::dvec3 right{1, 0, 0};  ///< the parallelogram's edges; perpendicular to `forward`
  glm::dvec3 down{0, -1, 0};
  glm::dvec3 forward{0, 0, -1};  ///< unit
  HalfSpace beyond;              ///< rays start where they enter it; those that do not hit nothing
};

/// A camera and its picture: makes eye rays and eye frames. The vertical extent is the camera's,
/// and the horizontal one follows from the picture's proportions. Pixel (0, 0) is at the top left
/// and its centre is (0.5, 0.5). `camera` is relative to World::origin. Thread-safe.
///
/// The whole scene is within `scene_radius` of the origin. For a camera a thousand times as far
/// away, rays start just before the scene, since floats of the camera's size would lose it.
///
/// Rays run from the camera's near_depth to its far_depth, if the scene extends beyond those.
///
/// With a lens, rays from any of its points pass the focus plane at the same place as the ray from
/// its centre. Frames, and rays without a lens point, are those of its centre. A lens with
/// automatic focus must be focused first (focused_camera); until then the view has no lens.
class View {
 public:
  View(const Camera& camera, int width, int height,
       double scene_radius = std::numeric_limits<double>::infinity());
  explicit View(const PyrayPicture& picture);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Returns the distance from the eye, or from the image plane, at which rays start: 0 except for
  /// far cameras and mirrors.
  [[nodiscard]] double start() const { return start_; }

  /// Returns the half-space ahead of the near plane, or of an orthographic view's image plane; none
  /// if rays start elsewhere.
  [[nodiscard]] std::optional<HalfSpace> ahead() const {
    if (beyond_ || (near_ == 0.0 && (perspective_ || start_ > 0.0))) return std::nullopt;
    return HalfSpace::through(eye_ + near_ * forward_, forward_);
  }
  /// Returns the half-space in front of the far plane; none if there is no such plane.
  [[nodiscard]] std::optional<HalfSpace> before() const {
    if (std::isinf(far_)) return std::nullopt;
    return HalfSpace::through(eye_ + far_ * forward_, -forward_);
  }

  /// Returns the depth of the near and of the far plane; 0 and infinite if there is none.
  [[nodiscard]] double near_depth() const { return near_; }
  [[nodiscard]] double far_depth() const { return far_; }

  /// Returns the eye ray through a point of the picture, in pixels, with a unit direction.
  [[nodiscard]] Ray ray(double x, double y) const;

  /// Computes the eye rays through many points; `rays` is as long as `points`.
  void rays(std::span<const glm::dvec2> points, std::span<Ray> rays) const;

  /// Returns a view of one pixel: a parallelogram of this picture, from its corner and edges in
  /// pixels. Its rays start and end where this view's do. It has no lens.
  [[nodiscard]] View parallelogram(glm::dvec2 corner, glm::dvec2 right, glm::dvec2 down) const;

  /// Returns whether there is depth of field.
  [[nodiscard]] bool has_lens() const { return lens_.blurs(); }
  /// Returns the lens with a known focus; without depth of field, a pinhole.
  [[nodiscard]] const Lens& lens() const { return lens_; }
  /// Returns the ray through a point of the picture that starts at a point of the lens.
  [[nodiscard]] Ray ray(double x, double y, const ExposurePoint& exposure) const;
  /// Returns the radius of the circle of confusion at a depth, in pixels; infinite depths are
  /// allowed.
  [[nodiscard]] double confusion(double depth) const {
    return confusion_ * std::abs(1.0 / depth - 1.0 / lens_.focus.value_or(1.0));
  }
  /// Returns the change of the radius over a difference of inverse depths.
  [[nodiscard]] double confusion_of_nearness(double difference) const {
    return confusion_ * difference;
  }
  /// Returns the depth in front of the focus plane with a circle of confusion of this radius.
  [[nodiscard]] double depth_before_focus(double radius) const {
    return 1.0 / (1.0 / lens_.focus.value_or(1.0) + radius / confusion_);
  }
  /// Returns the depth of a ray's point along the view axis.
  [[nodiscard]] double depth(const Ray& ray, float t) const {
    return glm::dot(forward_, glm::dvec3(ray.origin) - eye_) +
           static_cast<double>(t) * glm::dot(forward_, glm::dvec3(ray.direction));
  }

  /// Returns the frame of the pyray through a rectangle of the picture, in pixels: (u, v) runs from
  /// 0 to 1 from its top left to its bottom right corner.
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
