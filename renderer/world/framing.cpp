#include "renderer/world/framing.h"

#include "renderer/world/ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace asos {

namespace {

// With more triangles, the corners of objects' boxes are used, since visiting the corners of all
// triangles would be noticeably slow.
constexpr std::size_t most_triangles_framed = 4'000'000;

/// The largest and smallest value of a function of the points seen.
struct Extent {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void grow(double value) {
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
};

glm::dvec3 corner_of(const Box& box, int corner) {
  return {(corner & 1) ? box.hi.x : box.lo.x, (corner & 2) ? box.hi.y : box.lo.y,
          (corner & 4) ? box.hi.z : box.lo.z};
}

/// The extent of points in a camera's axes: right, up, and back to the eye. Also holds the
/// outermost planes through the points, parallel to the sides of a view frustum with half sides
/// `tangent` at distance 1.
class Reach {
 public:
  Reach(const Camera& camera, glm::dvec3 middle, glm::dvec2 tangent)
      : right_(camera.world_from_camera[0]),
        up_(camera.world_from_camera[1]),
        back_(camera.world_from_camera[2]),
        middle_(middle),
        tangent_(tangent) {}

  void add(glm::dvec3 point) {
    const glm::dvec3 d = point - middle_;
    const double x = glm::dot(d, right_), y = glm::dot(d, up_), z = glm::dot(d, back_);
    x_.grow(x);
    y_.grow(y);
    z_.grow(z);
    right_plane_ = std::max(right_plane_, x + tangent_.x * z);
    left_plane_ = std::max(left_plane_, -x + tangent_.x * z);
    upper_plane_ = std::max(upper_plane_, y + tangent_.y * z);
    lower_plane_ = std::max(lower_plane_, -y + tangent_.y * z);
  }
  void add_corners(const Box& box) {
    for (int corner = 0; corner < 8; ++corner) add(corner_of(box, corner));
  }
  [[nodiscard]] bool any() const { return x_.lo <= x_.hi; }

  /// Returns the nearest eye with all points between the four planes, in the camera's axes about
  /// the centre. Two opposite planes that touch a point each meet in a line, and the farther one of
  /// the two lines decides. In the other direction, the planes are equally far from the points.
  [[nodiscard]] glm::dvec3 perspective_eye(double least_gap) const {
    const double across = 0.5 * (right_plane_ + left_plane_) / tangent_.x;
    const double down = 0.5 * (upper_plane_ + lower_plane_) / tangent_.y;
    return {0.5 * (right_plane_ - left_plane_), 0.5 * (upper_plane_ - lower_plane_),
            std::max({across, down, z_.hi + least_gap})};
  }
  /// Returns an eye in front of all points, opposite their centre.
  [[nodiscard]] glm::dvec3 parallel_eye(double gap) const {
    return {0.5 * (x_.lo + x_.hi), 0.5 * (y_.lo + y_.hi), z_.hi + gap};
  }
  [[nodiscard]] double height(double aspect_ratio) const {
    return std::max(y_.hi - y_.lo, (x_.hi - x_.lo) / aspect_ratio);
  }

 private:
  glm::dvec3 right_, up_, back_, middle_;
  glm::dvec2 tangent_;
  Extent x_, y_, z_;
  double right_plane_ = -std::numeric_limits<double>::infinity();
  double left_plane_ = right_plane_, upper_plane_ = right_plane_, lower_plane_ = right_plane_;
};

/// The space of points that turn about a vertical axis, each on a circle.
class TurningReach {
 public:
  TurningReach(const Camera& camera, glm::dvec3 pivot, glm::dvec2 tangent)
      : pivot_(pivot), tangent_(tangent) {
    const glm::dvec3 back(camera.world_from_camera[2]);
    sine_ = std::clamp(back.y, -1.0, 1.0);
    cosine_ = std::sqrt(1.0 - sine_ * sine_);
  }

  void add(glm::dvec3 point) {
    const glm::dvec3 d = point - pivot_;
    const double radius = std::hypot(d.x, d.z);
    // At the angle a from the eye, the point is at (radius sin a, d.y cosine - radius cos a sine)
    // in the picture's plane, and at depth d.y sine + radius cos a cosine.
    const double aside = radius * std::sqrt(cosine_ * cosine_ + 1.0 / (tangent_.x * tangent_.x));
    distance_ = std::max(distance_, d.y * sine_ + aside);
    for (const double side : {-1.0, 1.0}) {
      const double tilt = side / tangent_.y;
      distance_ = std::max(
          distance_, d.y * (sine_ + tilt * cosine_) + radius * std::abs(cosine_ - tilt * sine_));
    }
    half_width_ = std::max(half_width_, radius);
    half_height_ = std::max(half_height_, std::abs(d.y) * cosine_ + radius * std::abs(sine_));
  }
  void add_corners(const Box& box) {
    for (int corner = 0; corner < 8; ++corner) add(corner_of(box, corner));
  }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] double height(double aspect_ratio) const {
    return 2.0 * std::max(half_height_, half_width_ / aspect_ratio);
  }

 private:
  glm::dvec3 pivot_;
  glm::dvec2 tangent_;
  double sine_ = 0.0, cosine_ = 1.0;  // of the eye's elevation
  double distance_ = 0.0, half_width_ = 0.0, half_height_ = 0.0;
};

// Adds the visible points. Boxes are used only for shapes and very large scenes, since most boxes'
// corners are empty.
template <typename Points>
void add_surfaces(const World& world, Points& reach) {
  // Lines and points come last, and the ground before them.
  const std::size_t grounds = world.materials.size() - materials_without_ground(world);
  const std::size_t triangles =
      triangles_without_ground(world) - world.lines_and_points.triangle_count;
  const bool each_triangle = triangles <= most_triangles_framed;
  if (each_triangle) {
    const std::size_t placed = world.triangles.size() - world.triangles.own().size();
    for (const glm::uvec3& triangle : std::span(world.triangles.own()).first(triangles - placed))
      for (int k = 0; k < 3; ++k) reach.add(glm::dvec3(world.positions[triangle[k]]));
    for (std::size_t v = world.positions.own().size(); v < world.positions.size(); ++v)
      reach.add(glm::dvec3(world.positions[v]));
  }
  // Use the lines and points themselves, since the triangles that draw them depend on the picture.
  for (const auto* lines_and_points :
       {&world.lines_and_points.segments, &world.lines_and_points.points}) {
    for (const LineOrPoint& stroke : *lines_and_points)
      reach.add(glm::dvec3(stroke.a)), reach.add(glm::dvec3(stroke.b));
  }
  for (const Part& part : std::span(world.parts).first(world.solid_parts() - grounds)) {
    if ((part.face_count > 0 || !each_triangle) && !part.bounds.empty())
      reach.add_corners(part.bounds);
  }
}

double plain_aspect(double aspect_ratio) {
  return std::isfinite(aspect_ratio) && aspect_ratio > 0.0 ? aspect_ratio : 1.0;
}

}  // namespace

void frame_also(World& world, const World& other) {
  const auto first = static_cast<std::uint32_t>(world.positions.size());
  const std::vector<glm::vec3>& positions = other.positions.own();
  world.positions.insert(world.positions.end(), positions.begin(), positions.end());
  for (const glm::uvec3 triangle : other.triangles.own())
    world.triangles.push_back(triangle + first);
  const auto solid = [](const World& w) { return static_cast<std::ptrdiff_t>(w.solid_parts()); };
  world.parts.insert(world.parts.begin() + solid(world), other.parts.begin(),
                     other.parts.begin() + solid(other));
  world.lines_and_points.first_part += static_cast<std::uint32_t>(solid(other));
  for (const auto member : {&LinesAndPoints::segments, &LinesAndPoints::points})
    (world.lines_and_points.*member)
        .insert((world.lines_and_points.*member).end(), (other.lines_and_points.*member).begin(),
                (other.lines_and_points.*member).end());
  world.lines_and_points.bounds.grow(other.lines_and_points.bounds);
  world.bounds.grow(other.bounds);
}

double room_to_turn(const World& world, const Camera& camera, glm::dvec3 pivot,
                    double aspect_ratio) {
  const double aspect = plain_aspect(aspect_ratio);
  const double tan_y = framed_share * std::tan(0.5 * camera.fov_y_rad);
  TurningReach reach(camera, pivot, {tan_y * aspect, tan_y});
  add_surfaces(world, reach);
  return camera.type == Camera::Type::perspective ? reach.distance()
                                                  : reach.height(aspect) / framed_share;
}

FramedView frame_world(const World& world, const Camera& camera, double aspect_ratio) {
  const double aspect = plain_aspect(aspect_ratio);
  Box bounds = world.lines_and_points.drawn() ? world.lines_and_points.others : world.bounds;
  if (ground_of(world) != Ground::off) bounds = bounds_without_ground(world);
  bounds.grow(world.lines_and_points.bounds);
  if (bounds.empty()) bounds.grow(glm::vec3(0.0f));
  const glm::dvec3 lo(bounds.lo), hi(bounds.hi), middle = 0.5 * (lo + hi);
  double radius = 0.5 * glm::length(hi - lo);

  const double tan_y = framed_share * std::tan(0.5 * camera.fov_y_rad);
  Reach reach(camera, middle, {tan_y * aspect, tan_y});
  if (radius > 0.0) {
    add_surfaces(world, reach);
    if (!reach.any()) reach.add_corners(bounds);
  } else {
    radius = 0.5 * std::sqrt(3.0);
    for (int corner = 0; corner < 8; ++corner)
      reach.add(middle + glm::dvec3((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                                    (corner & 4) ? 0.5 : -0.5));
  }

  FramedView framed{camera.without_planes(), 1.0};
  const bool perspective = camera.type == Camera::Type::perspective;
  constexpr double least_gap = 1e-3;  // radii; for a line that is seen end on
  const glm::dvec3 eye =
      perspective ? reach.perspective_eye(least_gap * radius) : reach.parallel_eye(radius);
  if (!perspective)
    framed.camera.height = std::max(reach.height(aspect), least_gap * radius) / framed_share;
  const glm::dmat3 axes(camera.world_from_camera);
  framed.camera.world_from_camera[3] = glm::dvec4(middle + axes * eye, 1.0);
  framed.subject_distance = std::max(eye.z, least_gap * radius);
  return framed;
}

}  // namespace asos
