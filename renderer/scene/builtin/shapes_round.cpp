#include "renderer/scene/builtin/shapes.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace asos::builtin {

namespace {

constexpr double pi = std::numbers::pi;

std::uint32_t add_vertex(Mesh& mesh, glm::vec3 position, glm::dvec3 normal) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(glm::vec3(glm::normalize(normal)));
  return vertex_count(mesh) - 1;
}

/// Two unit vectors that make a right-handed basis (x, axis, z) with the unit `axis`.
struct Basis {
  glm::dvec3 x, axis, z;

  explicit Basis(glm::dvec3 unit_axis) : axis(unit_axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    z = glm::normalize(glm::cross(other, axis));
    x = glm::cross(axis, z);
  }
  /// Radially outwards at an angle that runs counter-clockwise seen from the tip of the axis.
  [[nodiscard]] glm::dvec3 radial(double angle) const {
    return std::cos(angle) * x - std::sin(angle) * z;
  }
};

/// The normals (radial, axial) at both ends of each segment of a lathe's outline.
struct SegmentNormals {
  glm::dvec2 start, end;
};

std::vector<SegmentNormals> outline_normals(std::span<const glm::vec2> outline) {
  const double smooth = std::cos(35.0 * pi / 180.0);
  const auto blend = [smooth](glm::dvec2 own, glm::dvec2 neighbour) {
    return glm::dot(own, neighbour) > smooth ? glm::normalize(own + neighbour) : own;
  };
  std::vector<glm::dvec2> flat;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const glm::dvec2 along = glm::normalize(glm::dvec2(outline[i + 1]) - glm::dvec2(outline[i]));
    flat.emplace_back(along.y, -along.x);
  }
  std::vector<SegmentNormals> normals;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    // At the axis the neighbouring segment is the outline's own mirror image.
    const glm::dvec2 mirrored(-flat[i].x, flat[i].y);
    const bool from_axis = i == 0 && outline[0].x == 0.0f;
    const bool to_axis = i + 1 == flat.size() && outline.back().x == 0.0f;
    SegmentNormals ends{flat[i], flat[i]};
    if (from_axis || i > 0) ends.start = blend(flat[i], from_axis ? mirrored : flat[i - 1]);
    if (to_axis || i + 1 < flat.size()) ends.end = blend(flat[i], to_axis ? mirrored : flat[i + 1]);
    normals.push_back(ends);
  }
  return normals;
}

/// Appends one ring of `sides` vertices. At the axis all have one position, and normals halfway to
/// the next side, as the single triangle of that side needs.
std::uint32_t add_ring(Mesh& mesh, glm::dvec3 base, const Basis& basis, glm::dvec2 point,
                       glm::dvec2 normal, int sides) {
  const std::uint32_t first = vertex_count(mesh);
  const bool at_axis = point.x == 0.0;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * pi * (i + (at_axis ? 0.5 : 0.0)) / sides;
    const glm::dvec3 radial = basis.radial(angle);
    add_vertex(mesh, glm::vec3(base + point.x * radial + point.y * basis.axis),
               normal.x * radial + normal.y * basis.axis);
  }
  return first;
}

/// Joins two rings of `sides` vertices, the second further along the outline, so that an outline
/// that runs up gets triangles that face away from the axis. A ring that is a single point gets one
/// triangle per side.
void join_rings(Mesh& mesh, std::uint32_t first, std::uint32_t second, int sides,
                bool first_is_point = false, bool second_is_point = false) {
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    if (!first_is_point) mesh.triangles.emplace_back(first + i, first + next, second + i);
    if (second_is_point) continue;
    mesh.triangles.emplace_back(first_is_point ? first + i : first + next, second + next,
                                second + i);
  }
}

}  // namespace

void add_lathe(Mesh& mesh, glm::vec3 base, glm::vec3 axis, std::span<const glm::vec2> outline,
               int sides) {
  assert(outline.size() >= 2 && sides >= 3);
  const Basis basis(glm::normalize(glm::dvec3(axis)));
  const std::vector<SegmentNormals> normals = outline_normals(outline);
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const bool shares = i > 0 && normals[i - 1].end == normals[i].start;
    const std::uint32_t start =
        shares ? end : add_ring(mesh, base, basis, outline[i], normals[i].start, sides);
    end = add_ring(mesh, base, basis, outline[i + 1], normals[i].end, sides);
    join_rings(mesh, start, end, sides, outline[i].x == 0.0f, outline[i + 1].x == 0.0f);
  }
}

void add_frustum(Mesh& mesh, glm::vec3 base, glm::vec3 top, float base_radius, float top_radius,
                 int sides) {
  std::vector<glm::vec2> outline{{0.0f, 0.0f}};
  const float height = glm::length(top - base);
  if (base_radius > 0.0f) outline.emplace_back(base_radius, 0.0f);
  if (top_radius > 0.0f) outline.emplace_back(top_radius, height);
  outline.emplace_back(0.0f, height);
  add_lathe(mesh, base, top - base, outline, sides);
}

void add_disk(Mesh& mesh, glm::vec3 centre, glm::vec3 normal, float radius, int sides) {
  const Basis basis(glm::normalize(glm::dvec3(normal)));
  const std::uint32_t hub = add_vertex(mesh, centre, basis.axis);
  const std::uint32_t rim = add_ring(mesh, centre, basis, {radius, 0.0}, {0.0, 1.0}, sides);
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.emplace_back(hub, rim + i, rim + (i + 1) % n);
  }
}

UnitSphere unit_sphere(int n) {
  assert(n >= 1);
  UnitSphere sphere;
  sphere.directions.reserve(4u * n * n + 2u);
  sphere.triangles.reserve(8u * n * n);

  // Rows from the north pole to the south pole, each by the index of its first vertex.
  std::vector<std::uint32_t> row_start;
  for (int row = 0; row <= 2 * n; ++row) {
    row_start.push_back(static_cast<std::uint32_t>(sphere.directions.size()));
    const int quarter = std::min(row, 2 * n - row);
    const double polar = 0.5 * pi * row / n;
    if (quarter == 0) {
      sphere.directions.emplace_back(0.0f, row == 0 ? 1.0f : -1.0f, 0.0f);
      continue;
    }
    const double y = std::cos(polar), ring = std::sin(polar);
    for (int i = 0; i < 4 * quarter; ++i) {
      const double turn = 0.5 * pi * i / quarter;
      sphere.directions.emplace_back(ring * std::cos(turn), y, -ring * std::sin(turn));
    }
  }

  // Between two rows each quarter turn has `wide` edges on the row nearer to the equator and one
  // fewer on the other: a strip of alternating triangles.
  const auto at = [&row_start, n](int row, int i) {
    const int count = 4 * std::min(row, 2 * n - row);
    return row_start[row] + static_cast<std::uint32_t>(count == 0 ? 0 : i % count);
  };
  for (int wide = 1; wide <= n; ++wide) {
    const int narrow_row[2] = {wide - 1, 2 * n - wide + 1};
    const int wide_row[2] = {wide, 2 * n - wide};
    for (int half = 0; half < 2; ++half) {
      const auto add = [&sphere, half](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        sphere.triangles.emplace_back(a, half == 0 ? b : c, half == 0 ? c : b);
      };
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int w = quarter * wide, s = quarter * (wide - 1);
        for (int i = 0; i < wide; ++i) {
          add(at(wide_row[half], w + i), at(wide_row[half], w + i + 1),
              at(narrow_row[half], s + i));
          if (i + 1 == wide) break;
          add(at(narrow_row[half], s + i), at(wide_row[half], w + i + 1),
              at(narrow_row[half], s + i + 1));
        }
      }
    }
  }
  return sphere;
}

void add_sphere(Mesh& mesh, glm::vec3 centre, float radius, int n) {
  const UnitSphere sphere = unit_sphere(n);
  const std::uint32_t first = vertex_count(mesh);
  for (const glm::vec3& d : sphere.directions) add_vertex(mesh, centre + radius * d, d);
  for (const glm::uvec3& t : sphere.triangles) mesh.triangles.push_back(t + first);
}

void add_blob(Mesh& mesh, glm::vec3 centre, glm::vec3 size, const Blob& blob, int n) {
  const UnitSphere sphere = unit_sphere(n);
  const std::uint32_t first = vertex_count(mesh);
  mesh.positions.reserve(first + sphere.directions.size());
  mesh.normals.reserve(first + sphere.directions.size());
  mesh.triangles.reserve(mesh.triangles.size() + sphere.triangles.size());
  for (const glm::vec3& d : sphere.directions) {
    float r = 1.0f;
    glm::vec3 slope(0.0f);  // gradient of r as a function of all space
    for (const Blob::Bump& b : blob.bumps) {
      const float fall = b.sharpness * (glm::dot(d, b.towards) - 1.0f);
      if (fall < -17.0f) continue;  // less than a float near 1 can resolve
      const float h = b.height * std::exp(fall);
      r += h;
      slope += (h * b.sharpness) * b.towards;
    }
    for (const Blob::Ripple& w : blob.ripples) {
      const float phase = glm::dot(w.wave, d) + w.phase;
      r += w.height * std::sin(phase);
      slope += (w.height * std::cos(phase)) * w.wave;
    }
    // Along a tangent t of the unit sphere the surface moves by r t + (slope . t) d, so its normal
    // is r d - (slope without its part along d); a stretched surface's normal shrinks inversely.
    const glm::vec3 normal = r * d - (slope - glm::dot(slope, d) * d);
    mesh.positions.push_back(centre + size * (r * d));
    mesh.normals.push_back(glm::normalize(normal / size));
  }
  for (const glm::uvec3& t : sphere.triangles) mesh.triangles.push_back(t + first);
}

void add_tube(Mesh& mesh, std::span<const glm::vec3> path, float radius, int sides) {
  assert(path.size() >= 2);
  const auto tangent = [path](std::size_t i) {
    const glm::dvec3 before(path[i == 0 ? 0 : i - 1]);
    const glm::dvec3 after(path[i + 1 == path.size() ? i : i + 1]);
    return glm::normalize(after - before);
  };
  const auto cap = [&](std::uint32_t rim, glm::dvec3 centre, glm::dvec3 outwards, bool at_end) {
    const std::uint32_t hub = add_vertex(mesh, centre, outwards);
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < n; ++i) {
      add_vertex(mesh, mesh.positions[rim + i], outwards);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = hub + 1 + i, b = hub + 1 + (i + 1) % n;
      mesh.triangles.emplace_back(hub, at_end ? a : b, at_end ? b : a);
    }
  };

  Basis basis(tangent(0));
  std::uint32_t previous = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    // Rotates the frame by the smallest angle, so that the tube does not twist.
    basis.axis = tangent(i);
    basis.x = glm::normalize(basis.x - glm::dot(basis.x, basis.axis) * basis.axis);
    basis.z = glm::cross(basis.x, basis.axis);
    const std::uint32_t ring = add_ring(mesh, path[i], basis, {radius, 0.0}, {1.0, 0.0}, sides);
    if (i == 0) cap(ring, path[i], -basis.axis, false);
    if (i > 0) join_rings(mesh, previous, ring, sides);
    if (i + 1 == path.size()) cap(ring, path[i], basis.axis, true);
    previous = ring;
  }
}

void add_torus_knot(Mesh& mesh, glm::vec3 centre, const TorusKnot& knot, int segments, int sides) {
  assert(segments >= 3 && sides >= 3);
  std::vector<std::uint32_t> rings;
  for (int i = 0; i < segments; ++i) {
    // The curve, its tangent, and a normal towards the outside of the torus that it lies on.
    const double t = 2.0 * pi * i / segments;
    const double cp = std::cos(knot.p * t), sp = std::sin(knot.p * t);
    const double cq = std::cos(knot.q * t), sq = std::sin(knot.q * t);
    const double minor = knot.minor_radius;
    const double reach = knot.major_radius + minor * cq, reach_slope = -minor * knot.q * sq;
    const glm::dvec3 at(reach * cp, minor * sq, -reach * sp);
    const glm::dvec3 tangent(reach_slope * cp - reach * knot.p * sp, minor * knot.q * cq,
                             -reach_slope * sp - reach * knot.p * cp);
    const glm::dvec3 outwards(cq * cp, sq, -cq * sp);
    Basis basis(glm::normalize(tangent));
    basis.x = glm::normalize(outwards - glm::dot(outwards, basis.axis) * basis.axis);
    basis.z = glm::cross(basis.x, basis.axis);
    rings.push_back(
        add_ring(mesh, glm::dvec3(centre) + at, basis, {knot.tube_radius, 0.0}, {1.0, 0.0}, sides));
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    join_rings(mesh, rings[i], rings[(i + 1) % rings.size()], sides);
  }
}

}  // namespace asos::builtin
