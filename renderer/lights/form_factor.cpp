#include "renderer/lights/form_factor.h"

#include "renderer/lights/kinds/shared.h"

#include <algorithm>
#include <limits>

namespace asos {
namespace {

/// Sums the sides of a closed outline, given one corner after the other.
class ContourSum {
 public:
  explicit ContourSum(glm::dvec3 normal) : normal_(normal) {}

  void push(glm::dvec3 corner) {
    if (started_) {
      sum_ += contour_side(last_, corner, normal_);
    } else {
      first_ = corner;
      started_ = true;
    }
    last_ = corner;
  }
  void close() {
    if (started_) sum_ += contour_side(last_, first_, normal_);
  }
  [[nodiscard]] double sum() const { return sum_; }

 private:
  glm::dvec3 normal_;
  glm::dvec3 first_{0.0};
  glm::dvec3 last_{0.0};
  bool started_ = false;
  double sum_ = 0.0;
};

/// Clips a closed outline to a horizon, corner by corner (Sutherland and Hodgman 1974). The parts
/// of a concave outline are connected along the horizon there and back. These sides cancel, so the
/// contour sum of the result is right.
template <class Sink>
class HorizonClip {
 public:
  HorizonClip(glm::dvec3 normal, Sink& sink) : normal_(normal), sink_(sink) {}

  void push(glm::dvec3 corner) {
    const double height = glm::dot(normal_, corner);
    if (started_) {
      cross(corner, height);
    } else {
      first_ = corner;
      first_height_ = height;
      started_ = true;
    }
    if (height > 0.0) sink_.push(corner);
    last_ = corner;
    last_height_ = height;
  }
  void close() {
    if (started_) cross(first_, first_height_);
    sink_.close();
  }

 private:
  void cross(glm::dvec3 corner, double height) {
    if ((height > 0.0) == (last_height_ > 0.0)) return;
    sink_.push(last_ + (corner - last_) * (last_height_ / (last_height_ - height)));
  }

  glm::dvec3 normal_;
  Sink& sink_;
  glm::dvec3 first_{0.0};
  glm::dvec3 last_{0.0};
  double first_height_ = 0.0;
  double last_height_ = 0.0;
  bool started_ = false;
};

double clipped_form(std::span<const glm::dvec3> corners, const Receiver& receiver) {
  ContourSum sum(receiver.normal);
  HorizonClip by_geometric(receiver.geometric, sum);
  HorizonClip by_normal(receiver.normal, by_geometric);
  for (const glm::dvec3& corner : corners) by_normal.push(corner - receiver.position);
  by_normal.close();
  return sum.sum();
}

}  // namespace

double contour_side(glm::dvec3 a, glm::dvec3 b, glm::dvec3 normal) {
  return contour_term(a, b, normal);
}

double polygon_form(std::span<const glm::dvec3> corners, const Receiver& receiver) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest_normal = -lowest;
  double highest_geometric = -lowest;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 to_corner = corner - receiver.position;
    const double above_normal = glm::dot(to_corner, receiver.normal);
    const double above_geometric = glm::dot(to_corner, receiver.geometric);
    lowest = std::min(lowest, std::min(above_normal, above_geometric));
    highest_normal = std::max(highest_normal, above_normal);
    highest_geometric = std::max(highest_geometric, above_geometric);
  }
  if (!(highest_normal > 0.0) || !(highest_geometric > 0.0)) return 0.0;
  if (lowest < 0.0) return clipped_form(corners, receiver);

  ContourSum sum(receiver.normal);
  for (const glm::dvec3& corner : corners) sum.push(corner - receiver.position);
  sum.close();
  return sum.sum();
}

double polygon_form(std::span<const glm::dvec3> corners, glm::dvec3 normal) {
  return polygon_form(corners, Receiver{glm::dvec3(0.0), normal, normal});
}

}  // namespace asos
