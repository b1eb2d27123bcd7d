#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

// Builders of meshes for the built-in scenes. Each function appends one shape to `mesh`. Solids
// are closed: along every edge the positions of the two faces are equal to the bit, though their
// vertices are shared only where the surface is smooth. Faces wind counter-clockwise seen from
// outside, normals are unit and point outwards. Lengths are metres.

namespace asos::builtin {

/// The index that the next vertex of `mesh` will have.
[[nodiscard]] inline std::uint32_t vertex_count(const Mesh& mesh) {
  return static_cast<std::uint32_t>(mesh.positions.size());
}

/// A rectangle or other planar convex quadrilateral, open, facing the side from which a, b, c, d
/// run counter-clockwise.
void add_quad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d);

/// The plane area between the rectangles `outer` and `inner`, both counter-clockwise and starting
/// at the same corner: for instance a wall around a window. Open.
void add_rim(Mesh& mesh, std::span<const glm::vec3, 4> outer, std::span<const glm::vec3, 4> inner);

/// An axis-parallel box, flat-shaded: 12 triangles.
void add_box(Mesh& mesh, glm::vec3 lo, glm::vec3 hi);

/// The box of `size` around the origin, placed by a rigid `placement`.
void add_box(Mesh& mesh, glm::vec3 size, const glm::mat4& placement);

/// A box along a segment: its end faces have their centres at `from` and `to`, `width` runs across
/// and `height` towards `up`, which must not be parallel to the segment.
void add_beam(Mesh& mesh, glm::vec3 from, glm::vec3 to, float width, float height,
              glm::vec3 up = {0.0f, 1.0f, 0.0f});

/// Gives a whole flat-shaded mesh its first texture coordinates, in metres along each face: u along
/// the horizontal and v downwards; on a horizontal face along x and towards +z.
void add_texcoords(Mesh& mesh);

/// An outline in the xy plane, counter-clockwise, extruded from z = 0 to `depth` and placed by a
/// rigid `placement`; flat-shaded. `cap` triangulates the outline: indices of its points, with its
/// winding.
void add_extrusion(Mesh& mesh, std::span<const glm::vec2> outline, std::span<const glm::uvec3> cap,
                   float depth, const glm::mat4& placement = glm::mat4(1.0f));

/// The extrusion of a convex outline: 4 n - 4 triangles.
void add_prism(Mesh& mesh, std::span<const glm::vec2> outline, float depth,
               const glm::mat4& placement = glm::mat4(1.0f));

/// A rectangular frame, as of a picture: a slab in the xy plane around the origin, from z = 0 to
/// `depth`, of half size `outer` with a hole of half size `inner`. Flat-shaded, 32 triangles.
void add_frame(Mesh& mesh, glm::vec2 outer, glm::vec2 inner, float depth,
               const glm::mat4& placement = glm::mat4(1.0f));

/// A polyline of (radius, height) rotated about the axis that starts at `base`. The outline runs
/// counter-clockwise (outwards along the bottom, up, inwards along the top); it is a closed solid
/// if it starts and ends at radius 0. Corners of less than 35 degrees are smooth.
void add_lathe(Mesh& mesh, glm::vec3 base, glm::vec3 axis, std::span<const glm::vec2> outline,
               int sides);

/// A cylinder, cone or truncated cone between two points: smooth side, flat caps. One of the radii
/// may be 0.
void add_frustum(Mesh& mesh, glm::vec3 base, glm::vec3 top, float base_radius, float top_radius,
                 int sides);

/// A flat disk, open.
void add_disk(Mesh& mesh, glm::vec3 centre, glm::vec3 normal, float radius, int sides);

/// Directions evenly distributed over the unit sphere, joined to 8 n^2 triangles of nearly equal
/// size: row k of each half has 4 k points, so there are neither slivers nor seams.
struct UnitSphere {
  std::vector<glm::vec3> directions;
  std::vector<glm::uvec3> triangles;
};
[[nodiscard]] UnitSphere unit_sphere(int n);

/// A smooth sphere of 8 n^2 triangles with exact normals.
void add_sphere(Mesh& mesh, glm::vec3 centre, float radius, int n);

/// A tube of constant radius along an open polyline, with flat ends. It is smooth around and along
/// the path, whose points should be dense enough for that. It does not self-intersect if `radius`
/// is small compared with the path's radius of curvature.
void add_tube(Mesh& mesh, std::span<const glm::vec3> path, float radius, int sides);

/// A tube along the torus knot that winds `p` times around the axis (+Y through `centre`) and `q`
/// times through the hole; 2 * segments * sides triangles, exact normals.
struct TorusKnot {
  int p = 2;
  int q = 3;
  float major_radius = 1.0f;
  float minor_radius = 0.4f;
  float tube_radius = 0.2f;
};
void add_torus_knot(Mesh& mesh, glm::vec3 centre, const TorusKnot& knot, int segments, int sides);

/// The surface r(d) d over directions d, where r is 1 plus the sum of the bumps and ripples, scaled
/// by `size` and moved to `centre`: star-shaped, closed, smooth, with exact normals; 8 n^2
/// triangles.
struct Blob {
  struct Bump {  ///< height * exp(sharpness * (d . towards - 1))
    glm::vec3 towards;
    float height;
    float sharpness;
  };
  struct Ripple {  ///< height * sin(wave . d + phase)
    glm::vec3 wave;
    float height;
    float phase;
  };
  std::vector<Bump> bumps;
  std::vector<Ripple> ripples;
};
void add_blob(Mesh& mesh, glm::vec3 centre, glm::vec3 size, const Blob& blob, int n);

}  // namespace asos::builtin
