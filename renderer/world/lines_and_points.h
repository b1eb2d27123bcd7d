#pragma once

#include "renderer/geometry/box.h"
#include "renderer/geometry/camera.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

struct World;

/// A line segment, or a point (both ends equal), relative to World::origin.
struct LineOrPoint {
  glm::vec3 a;
  glm::vec3 b;
  glm::vec4 color_a{1.0f};  ///< linear RGBA, of the vertices
  glm::vec4 color_b{1.0f};
  std::uint32_t part = 0;  ///< index into World::parts
};

/// Normals and texture coordinates at the ends of a segment; both ends of a point are the same.
struct LineLook {
  glm::vec3 normals[2]{};       ///< unit, by end; 0: none, replaced by the direction to the eye
  glm::vec2 texcoords[2][2]{};  ///< by set and end
};

/// The lines and points of a world. They have surfaces only for a certain picture: see
/// draw_lines. Their parts, triangles and vertices are the last ones.
struct LinesAndPoints {
  std::vector<LineOrPoint> segments;
  std::vector<LineOrPoint> points;
  /// One per segment and per point; empty if none has normals or texture coordinates.
  std::vector<LineLook> segment_looks, point_looks;
  Box bounds;  ///< of all segments and points
  std::uint32_t first_part = 0;
  // The following describe the drawn lines and points.
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  Box others;  ///< World::bounds without lines and points

  [[nodiscard]] bool empty() const { return segments.empty() && points.empty(); }
  /// Returns whether a triangle of the world, or one of its vertices, belongs to a line or point.
  [[nodiscard]] bool has_triangle(std::uint32_t triangle) const {
    return triangle - first_triangle < triangle_count;
  }
  [[nodiscard]] bool has_vertex(std::uint32_t vertex) const {
    return vertex - first_vertex < vertex_count;
  }
  [[nodiscard]] bool drawn() const { return vertex_count > 0; }
};

/// The picture in which lines and points appear.
struct LinePicture {
  Camera camera;       ///< relative to World::origin
  int height = 1;      ///< pixels
  double width = 1.0;  ///< width of lines and diameter of points, in pixels; 0: there are none
};

/// The number of triangles and vertices that `draw_lines` would add.
struct LineSize {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
};
[[nodiscard]] LineSize size_of_lines(const World& world, const LinePicture& picture);

/// Draws a world's lines and points as surfaces that face the camera, in place of those for another
/// picture. A segment becomes a ribbon that projects to a rectangle of LinePicture::width around
/// the segment, with butt ends. A point becomes a regular polygon with the area of its disk. The
/// surfaces are moved nearer by one of their widths, so that lines on a surface are not buried in
/// it. Mirrors may show lines behind the camera: these are as wide as in front of it. Needs 32
/// bits for triangles and vertices (size_of_lines). Omits lines and points without extent in the
/// picture.
void draw_lines(World& world, const LinePicture& picture);

}  // namespace asos
