#include "renderer/geometry/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

double radius_around_origin(const Box& box) {
  if (box.empty()) return std::numeric_limits<double>::infinity();
  return glm::length(glm::max(glm::abs(glm::dvec3(box.lo)), glm::abs(glm::dvec3(box.hi))));
}

View::View(const Camera& camera, int width, int height, double scene_radius)
    : perspective_(camera.type == Camera::Type::perspective), width_(width), height_(height) {
  const glm::dmat4& m = camera.world_from_camera;
  const glm::dvec3 right(m[0]), up(m[1]);
  forward_ = -glm::dvec3(m[2]);
  eye_ = glm::dvec3(m[3]);
  const double full_height = perspective_ ? 2.0 * std::tan(0.5 * camera.fov_y_rad) : camera.height;
  const double pixel = full_height / height;
  pixel_right_ = right * pixel;
  pixel_down_ = -up * pixel;
  corner_ = forward_ - (0.5 * width) * pixel_right_ - (0.5 * height) * pixel_down_;
  constexpr double far = 1024.0;
  const double distance = perspective_ ? glm::length(eye_) : -glm::dot(eye_, forward_);
  if (distance > far * scene_radius) start_ = distance - 2.0 * scene_radius;
  set_planes(camera, scene_radius);
  if (!perspective_ || !camera.lens.blurs() || !camera.lens.focus) return;
  lens_ = camera.lens;
  lens_right_ = right;
  lens_up_ = up;
  confusion_ = lens_.radius / pixel;
}

// Planes that cut off nothing of the scene are left out, since rays without ends are cheaper.
void View::set_planes(const Camera& camera, double scene_radius) {
  const double middle = -glm::dot(eye_, forward_);
  if (camera.near_depth && *camera.near_depth > std::max(0.0, middle - scene_radius))
    near_ = *camera.near_depth;
  if (camera.far_depth && *camera.far_depth < middle + scene_radius) far_ = *camera.far_depth;
}

void View::cut(Ray& ray, glm::dvec3 direction) const {
  const double way = 1.0 / (perspective_ ? glm::dot(forward_, direction) : 1.0);
  ray.t_near = static_cast<float>(std::max(0.0, near_ * way - start_));
  ray.t_far = static_cast<float>(far_ * way - start_);
}

View::View(const PyrayPicture& picture)
    : perspective_(picture.perspective),
      eye_(picture.apex),
      corner_(picture.corner),
      pixel_right_(picture.right),
      pixel_down_(picture.down),
      forward_(picture.forward),
      width_(1),
      height_(1),
      beyond_(picture.beyond) {
  // Start rays halfway to where the first of them enters, since floats lose less precision from
  // there.
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 p : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    const glm::dvec3 target = corner_ + p.x * pixel_right_ + p.y * pixel_down_;
    const glm::dvec3 from = perspective_ ? eye_ : eye_ + target - forward_;
    const glm::dvec3 direction = perspective_ ? glm::normalize(target) : forward_;
    const double t = -beyond_->height(from) / glm::dot(beyond_->normal, direction);
    if (t < nearest) nearest = t;
  }
  if (nearest > 0.0 && std::isfinite(nearest)) start_ = 0.5 * nearest;
}

View View::parallelogram(glm::dvec2 corner, glm::dvec2 right, glm::dvec2 down) const {
  const auto in_world = [&](glm::dvec2 p) { return p.x * pixel_right_ + p.y * pixel_down_; };
  View part = *this;
  part.corner_ = corner_ + in_world(corner);
  part.pixel_right_ = in_world(right);
  part.pixel_down_ = in_world(down);
  part.width_ = part.height_ = 1;
  part.lens_ = {};
  return part;
}

Ray View::ray(double x, double y) const {
  const glm::dvec3 target = corner_ + x * pixel_right_ + y * pixel_down_;
  const glm::dvec3 direction = perspective_ ? glm::normalize(target) : forward_;
  Ray ray;
  if (perspective_) {
    ray.origin = glm::vec3(eye_ + start_ * direction);
    ray.direction = glm::vec3(direction);
  } else {
    ray.origin = glm::vec3(eye_ + target - forward_ + start_ * forward_);
    ray.direction = glm::vec3(forward_);
  }
  if (cuts()) cut(ray, direction);
  if (!beyond_) return ray;
  const double height = beyond_->height(glm::dvec3(ray.origin));
  const double slope = glm::dot(beyond_->normal, glm::dvec3(ray.direction));
  if (height < 0.0)
    ray.t_near =
        slope > 0.0 ? static_cast<float>(-height / slope) : std::numeric_limits<float>::infinity();
  return ray;
}

// A point of the focus plane is at the same place of the picture for all points of the lens.
Ray View::ray(double x, double y, const ExposurePoint& exposure) const {
  const glm::dvec3 from = exposure.lens.x * lens_right_ + exposure.lens.y * lens_up_;
  const glm::dvec3 target = corner_ + x * pixel_right_ + y * pixel_down_;
  // Scaled so that it does not overflow for a near focus.
  const double focus = *lens_.focus;
  const glm::dvec3 direction =
      glm::normalize(focus < 1.0 ? focus * target - from : target - from / focus);
  Ray ray;
  ray.origin = glm::vec3(eye_ + from + start_ * direction);
  ray.direction = glm::vec3(direction);
  if (cuts()) cut(ray, direction);
  return ray;
}

void View::rays(std::span<const glm::dvec2> points, std::span<Ray> rays) const {
  if (!perspective_ || beyond_) {
    for (std::size_t i = 0; i < points.size(); ++i) rays[i] = ray(points[i].x, points[i].y);
    return;
  }
  // Compute the same bits as `ray` does, in loops that compilers vectorize.
  constexpr std::size_t some = 16;
  double x[some], y[some], z[some], nearness[some];
  for (std::size_t first = 0; first < points.size(); first += some) {
    const std::size_t count = std::min(some, points.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2 p = points[first + i];
      x[i] = corner_.x + p.x * pixel_right_.x + p.y * pixel_down_.x;
      y[i] = corner_.y + p.x * pixel_right_.y + p.y * pixel_down_.y;
      z[i] = corner_.z + p.x * pixel_right_.z + p.y * pixel_down_.z;
    }
    for (std::size_t i = count; i < some; ++i) x[i] = y[i] = z[i] = 1.0;
    for (std::size_t i = 0; i < some; ++i)
      nearness[i] = 1.0 / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 direction = glm::dvec3(x[i], y[i], z[i]) * nearness[i];
      Ray& ray = rays[first + i];
      ray.origin = glm::vec3(eye_ + start_ * direction);
      ray.t_near = 0.0f;
      ray.direction = glm::vec3(direction);
      ray.t_far = std::numeric_limits<float>::infinity();
      if (cuts()) cut(ray, direction);
    }
  }
}

Frame View::frame(double x, double y, double width, double height) const {
  const glm::dvec3 corner = corner_ + x * pixel_right_ + y * pixel_down_;
  const glm::dvec3 a = width * pixel_right_;
  const glm::dvec3 b = height * pixel_down_;
  if (perspective_) return Frame::pyramid(eye_, corner, a, b);
  return Frame::prism(eye_ + corner - forward_, forward_, a, b);
}

}  // namespace asos
