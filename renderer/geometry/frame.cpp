#include "renderer/geometry/frame.h"

namespace asos {

Frame::Frame(bool parallel, glm::dvec3 apex, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b,
             glm::dvec3 c)
    : parallel_(parallel), apex_(apex), direction_(direction), a_(a), b_(b), c_(c) {
  // The rows of the inverse of a matrix with columns a, b, c are the cross products of the other
  // two columns over the determinant.
  const double det = glm::dot(a, glm::cross(b, c));
  row_u_ = glm::cross(b, c) / det;
  row_v_ = glm::cross(c, a) / det;
  row_w_ = glm::cross(a, b) / det;
}

Frame Frame::pyramid(glm::dvec3 apex, glm::dvec3 c, glm::dvec3 a, glm::dvec3 b) {
  return {false, apex, glm::normalize(c + 0.5 * (a + b)), a, b, c};
}

Frame Frame::prism(glm::dvec3 corner, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b) {
  return {true, corner, direction, a, b, direction};
}

glm::dvec3 Frame::world(FramePoint p) const {
  if (parallel_) return apex_ + p.u * a_ + p.v * b_ - p.nearness * c_;
  return apex_ + (p.u * a_ + p.v * b_ + c_) / p.nearness;
}

std::optional<glm::dvec3> Frame::on_plane(glm::dvec2 uv, const HalfSpace& plane) const {
  return PlaneCrossings(*this, plane).at(uv);
}

}  // namespace asos
