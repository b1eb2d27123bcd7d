#include "renderer/world/lines_and_points.h"

#include "renderer/geometry/direction.h"
#include "renderer/world/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace asos {
namespace {

// Points up to this width, in pixels, are octagons.
constexpr double small_point = 2.0;
constexpr int small_corners = 8;
constexpr int large_corners = 16;

int corners_of(double width) {
  return width <= small_point ? small_corners : large_corners;
}

/// A camera's axes: a point's x and y over its depth are its position in the picture plane one unit
/// ahead.
class Eye {
 public:
  explicit Eye(const LinePicture& picture)
      : right_(picture.camera.world_from_camera[0]),
        up_(picture.camera.world_from_camera[1]),
        back_(picture.camera.world_from_camera[2]),
        eye_(picture.camera.world_from_camera[3]),
        perspective_(picture.camera.type == Camera::Type::perspective) {
    const double tall =
        perspective_ ? 2.0 * std::tan(0.5 * picture.camera.fov_y_rad) : picture.camera.height;
    width_ = picture.width * tall / picture.height;
  }

  /// Returns a point of the world in the camera's axes: right, up, and ahead.
  [[nodiscard]] glm::dvec3 seen(glm::dvec3 world) const {
    const glm::dvec3 d = world - eye_;
    return {glm::dot(d, right_), glm::dot(d, up_), -glm::dot(d, back_)};
  }
  /// Returns the world position of a point in the camera's axes, moved nearer by one width.
  [[nodiscard]] glm::vec3 drawn(glm::dvec3 seen) const {
    if (perspective_)
      seen *= std::max(0.5, 1.0 - width_);
    else
      seen.z -= width_;
    return glm::vec3(eye_ + seen.x * right_ + seen.y * up_ - seen.z * back_);
  }
  [[nodiscard]] glm::vec3 towards_eye() const { return glm::vec3(glm::normalize(back_)); }
  [[nodiscard]] glm::dvec2 projected(glm::dvec3 seen) const {
    return perspective_ ? glm::dvec2(seen) / seen.z : glm::dvec2(seen);
  }
  /// Returns half of a line's width at a place in the camera's axes, across the line of sight.
  [[nodiscard]] double half_width(glm::dvec3 seen) const {
    return 0.5 * width_ * (perspective_ ? std::abs(seen.z) : 1.0);
  }
  [[nodiscard]] bool perspective() const { return perspective_; }

 private:
  glm::dvec3 right_, up_, back_, eye_;
  bool perspective_;
  double width_ = 0.0;  // one unit ahead; for parallel rays, anywhere
};

class Drawer {
 public:
  /// `textured`: the sets of texture coordinates that vertices have.
  Drawer(World& world, const LinePicture& picture, bool coloured, std::array<bool, 2> textured)
      : world_(world),
        eye_(picture),
        corners_(corners_of(picture.width)),
        coloured_(coloured),
        textured_(textured) {}

  // Draws one part after the other, since a part's triangles are consecutive.
  void run() {
    std::size_t segment = 0, point = 0;
    const LinesAndPoints& lines_and_points = world_.lines_and_points;
    for (std::uint32_t p = lines_and_points.first_part; p < world_.parts.size(); ++p) {
      part_ = &world_.parts[p];
      part_->first_triangle = static_cast<std::uint32_t>(world_.triangles.size());
      part_->first_vertex = static_cast<std::uint32_t>(world_.positions.size());
      for (; segment < lines_and_points.segments.size() &&
             lines_and_points.segments[segment].part == p;
           ++segment) {
        look_ = look_of(lines_and_points.segment_looks, segment);
        add_segment(lines_and_points.segments[segment]);
      }
      for (; point < lines_and_points.points.size() && lines_and_points.points[point].part == p;
           ++point) {
        look_ = look_of(lines_and_points.point_looks, point);
        add_point(lines_and_points.points[point]);
      }
      part_->triangle_count =
          static_cast<std::uint32_t>(world_.triangles.size()) - part_->first_triangle;
      part_->vertex_count =
          static_cast<std::uint32_t>(world_.positions.size()) - part_->first_vertex;
      world_.bounds.grow(part_->bounds);
    }
  }

 private:
  // Places nearer than this fraction of the farther end's depth cannot be projected.
  static constexpr double nearest_share = 1e-6;

  [[nodiscard]] static LineLook look_of(const std::vector<LineLook>& looks, std::size_t i) {
    return i < looks.size() ? looks[i] : LineLook{};
  }

  void add_segment(const LineOrPoint& stroke) {
    const glm::dvec3 a = eye_.seen(glm::dvec3(stroke.a)), b = eye_.seen(glm::dvec3(stroke.b));
    if (!eye_.perspective()) return add_ribbon(stroke, a, b, 0.0, 1.0);
    const double near = nearest_share * std::max(std::abs(a.z), std::abs(b.z));
    for (const double side : {1.0, -1.0}) {
      // The segment's range from t0 to t1 whose depth times `side` is at least `near`.
      const double za = side * a.z - near, zb = side * b.z - near;
      if (za < 0.0 && zb < 0.0) continue;
      const double cut = za / (za - zb);
      add_ribbon(stroke, a, b, za < 0.0 ? cut : 0.0, zb < 0.0 ? cut : 1.0);
    }
  }

  void add_ribbon(const LineOrPoint& stroke, glm::dvec3 a, glm::dvec3 b, double t0, double t1) {
    const std::array<glm::dvec3, 2> ends{glm::mix(a, b, t0), glm::mix(a, b, t1)};
    const glm::dvec2 along = eye_.projected(ends[1]) - eye_.projected(ends[0]);
    const double length = glm::length(along);
    if (!(length > 0.0) || !std::isfinite(length)) return;
    const glm::dvec3 across(-along.y / length, along.x / length, 0.0);
    const auto first = static_cast<std::uint32_t>(world_.positions.size());
    for (int end = 0; end < 2; ++end) {
      const auto t = static_cast<float>(end == 0 ? t0 : t1);
      const glm::vec4 color = glm::mix(stroke.color_a, stroke.color_b, t);
      const glm::dvec3 half = across * eye_.half_width(ends[end]);
      add_vertex(ends[end] + half, color, t);
      add_vertex(ends[end] - half, color, t);
    }
    add_triangle({first, first + 1, first + 2});
    add_triangle({first + 2, first + 1, first + 3});
  }

  void add_point(const LineOrPoint& stroke) {
    const glm::dvec3 middle = eye_.seen(glm::dvec3(stroke.a));
    if (eye_.perspective() && middle.z == 0.0) return;
    // A regular polygon of n corners has the area n / 2 sin(2 pi / n) r^2.
    const double step = 2.0 * std::numbers::pi / corners_;
    const double radius = eye_.half_width(middle) * std::sqrt(step / std::sin(step));
    const auto first = static_cast<std::uint32_t>(world_.positions.size());
    for (int i = 0; i < corners_; ++i) {
      const double angle = step * i;
      add_vertex(middle + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0),
                 stroke.color_a, 0.0f);
    }
    for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(corners_); ++i)
      add_triangle({first, first + i - 1, first + i});
  }

  /// `t` is the vertex's position along the stroke, 0 to 1.
  void add_vertex(glm::dvec3 seen, glm::vec4 color, float t) {
    const glm::vec3 position = eye_.drawn(seen);
    world_.positions.push_back(position);
    part_->bounds.grow(position);
    const glm::dvec3 normal(glm::mix(look_.normals[0], look_.normals[1], t));
    world_.normals.push_back(unit_or(normal, eye_.towards_eye()));
    if (!world_.tangents.empty()) world_.tangents.emplace_back(0.0f);
    for (int set = 0; set < 2; ++set)
      if (textured_[set])
        world_.texcoords[set].push_back(
            glm::mix(look_.texcoords[set][0], look_.texcoords[set][1], t));
    if (coloured_) world_.colors.push_back(color);
  }

  void add_triangle(glm::uvec3 corners) {
    world_.triangles.push_back(corners);
    world_.triangle_part.push_back(static_cast<std::uint32_t>(part_ - world_.parts.data()));
  }

  World& world_;
  Eye eye_;
  int corners_;
  bool coloured_;  // vertices have colours
  std::array<bool, 2> textured_;
  LineLook look_;  // of the current stroke
  Part* part_ = nullptr;
};

/// Removes the surfaces drawn for the previous picture.
void clear_lines(World& world) {
  LinesAndPoints& lines_and_points = world.lines_and_points;
  if (!lines_and_points.drawn()) return;
  world.positions.resize(lines_and_points.first_vertex);
  world.normals.resize(lines_and_points.first_vertex);
  if (!world.tangents.empty()) world.tangents.resize(lines_and_points.first_vertex);
  for (auto& texcoords : world.texcoords)
    if (!texcoords.empty()) texcoords.resize(lines_and_points.first_vertex);
  if (!world.colors.empty()) world.colors.resize(lines_and_points.first_vertex);
  world.triangles.resize(lines_and_points.first_triangle);
  world.triangle_part.erase(world.triangle_part.begin() + lines_and_points.first_triangle,
                            world.triangle_part.begin() + lines_and_points.first_triangle +
                                lines_and_points.triangle_count);
  for (std::size_t p = lines_and_points.first_part; p < world.parts.size(); ++p) {
    Part& part = world.parts[p];
    part.triangle_count = part.vertex_count = 0;
    part.surfaces = 0;
    part.bounds = Box();
  }
  world.bounds = lines_and_points.others;
  lines_and_points.triangle_count = lines_and_points.vertex_count = 0;
}

/// Returns the sets of texture coordinates that the strokes' materials use.
std::array<bool, 2> textured_sets(const World& world) {
  std::array<bool, 2> sets{};
  for (const Part& part : world.parts) {
    if (!part.lines_and_points) continue;
    for (const TextureUse* use : texture_uses(world.materials[part.material]))
      if (use->used()) sets[static_cast<std::size_t>(use->texcoord)] = true;
  }
  return sets;
}

bool coloured(const std::vector<LineOrPoint>& lines_and_points) {
  return std::any_of(lines_and_points.begin(), lines_and_points.end(), [](const LineOrPoint& s) {
    return s.color_a != glm::vec4(1.0f) || s.color_b != glm::vec4(1.0f);
  });
}

}  // namespace

LineSize size_of_lines(const World& world, const LinePicture& picture) {
  const auto corners = static_cast<std::uint64_t>(corners_of(picture.width));
  const std::uint64_t segments = world.lines_and_points.segments.size();
  const std::uint64_t points = world.lines_and_points.points.size();
  // A segment may pass the camera, and then has a ribbon on each side.
  return {4 * segments + (corners - 2) * points, 8 * segments + corners * points};
}

void draw_lines(World& world, const LinePicture& picture) {
  clear_lines(world);
  LinesAndPoints& lines_and_points = world.lines_and_points;
  if (lines_and_points.empty() || !(picture.width > 0.0)) return;
  lines_and_points.others = world.bounds;
  lines_and_points.first_vertex = static_cast<std::uint32_t>(world.positions.size());
  lines_and_points.first_triangle = static_cast<std::uint32_t>(world.triangles.size());
  const bool any_colours = !world.colors.empty() || coloured(lines_and_points.segments) ||
                           coloured(lines_and_points.points);
  if (any_colours) world.colors.resize(world.positions.size(), glm::vec4(1.0f));

  std::array<bool, 2> textured = textured_sets(world);
  for (std::size_t set = 0; set < 2; ++set) {
    textured[set] |= !world.texcoords[set].empty();
    if (textured[set]) world.texcoords[set].resize(world.positions.size(), glm::vec2(0.0f));
  }

  // Face numbers follow triangle numbers, so the faces' entries move behind the drawn triangles.
  const std::vector<std::uint32_t> of_faces(
      world.triangle_part.begin() + lines_and_points.first_triangle, world.triangle_part.end());
  world.triangle_part.resize(lines_and_points.first_triangle);
  Drawer(world, picture, any_colours, textured).run();
  lines_and_points.vertex_count =
      static_cast<std::uint32_t>(world.positions.size()) - lines_and_points.first_vertex;
  lines_and_points.triangle_count =
      static_cast<std::uint32_t>(world.triangles.size()) - lines_and_points.first_triangle;
  world.triangle_part.insert(world.triangle_part.end(), of_faces.begin(), of_faces.end());
  world.positions.reserve(world.positions.size() + 1);  // see World::positions
}

}  // namespace asos
