#pragma once

#include "renderer/geometry/box.h"
#include "renderer/geometry/shape_face.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/world/attribute.h"
#include "renderer/world/lines_and_points.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// The consecutive triangles, or faces, of one instance: one object with one material.
struct Part {
  std::string name;
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t material = 0;     ///< index into World::materials, always valid
  bool shows_light = false;       ///< see Instance::shows_light
  bool coloured = false;          ///< whether any vertex of it is not white
  Box bounds;                     ///< of the positions that its triangles use; empty: unknown
  std::uint32_t face_count = 0;   ///< faces of an analytic shape; such a part has no triangles
  bool lines_and_points = false;  ///< of lines or points, which are drawn for each picture
  int node = -1;                  ///< index into SceneContents::nodes; -1: it has none
  /// The same number in all worlds that have these surfaces, in the same places; 0: in no other.
  std::uint64_t surfaces = 0;

  [[nodiscard]] bool shows_nothing() const {
    return triangle_count == 0 && face_count == 0 && !lines_and_points;
  }
};

/// Returns a number that no other part has: see Part::surfaces. Thread-safe.
[[nodiscard]] std::uint64_t new_surfaces_id();

/// A scene's surfaces flattened into one indexed triangle soup, placed in the world and recentred
/// in double precision (design section 10): `position + origin` is the author's coordinate.
/// Immutable once shared. Arrays of unused attributes are empty (design section 8). Large meshes
/// with several instances are stored once (Placements); their triangles and vertices come after all
/// others.
struct World {
  glm::dvec3 origin{0.0};
  Attribute<glm::vec3> positions;                ///< capacity for one more avoids a copy for rays
  Attribute<glm::vec3> normals;                  ///< unit, one per vertex
  Attribute<glm::vec4> tangents;                 ///< or empty; 0 for meshes without tangents
  Attribute<glm::vec2> texcoords[2];             ///< or empty
  Attribute<glm::vec4> colors;                   ///< linear RGBA, or empty
  Attribute<glm::uvec3> triangles;               ///< into positions
  std::vector<ShapeFace> faces;                  ///< of analytic shapes; none with placed meshes
  Attribute<std::uint32_t> triangle_part;        ///< the part of each triangle, then of each face
  std::shared_ptr<const Placements> placements;  ///< see set_placements; null: none
  bool flat = false;  ///< for a shared mesh: it has no normals, and three vertices per triangle
  std::vector<Part> parts;
  /// The scene's materials, then glTF's default material, those of lines and points, and the
  /// ground's.
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Camera> cameras;  ///< relative to origin
  Box bounds;                   ///< of the positions that triangles use; empty if none
  LinesAndPoints lines_and_points;

  /// Every surface has one number: a triangle's index, or that of a face of an analytic shape,
  /// which come after all triangles.
  [[nodiscard]] bool is_face(std::uint32_t surface) const { return surface >= triangles.size(); }
  [[nodiscard]] const ShapeFace& face(std::uint32_t surface) const {
    return faces[surface - triangles.size()];
  }
  [[nodiscard]] std::uint32_t surface_count() const {
    return static_cast<std::uint32_t>(triangles.size() + faces.size());
  }
  /// Returns the number of parts without those of lines and points, which come last.
  [[nodiscard]] std::size_t solid_parts() const {
    return lines_and_points.empty() ? parts.size() : lines_and_points.first_part;
  }
  /// Returns the number of triangles without those of lines and points, which come last.
  [[nodiscard]] std::size_t solid_triangles() const {
    return triangles.size() - lines_and_points.triangle_count;
  }
  /// Returns whether the world has no surface, line or point.
  [[nodiscard]] bool shows_nothing() const {
    return surface_count() == 0 && lines_and_points.empty();
  }

  /// Returns whether a triangle belongs to a mesh that is stored once for several instances.
  [[nodiscard]] bool is_placed(std::uint32_t triangle) const {
    return placements && triangle >= triangles.own_size();
  }
  /// Adds placed meshes after everything that the world has of its own, which may have grown since
  /// the last call. Null: none.
  void set_placements(std::shared_ptr<const Placements> placed);

  /// Returns the index of a surface's material in `materials`.
  [[nodiscard]] std::uint32_t material_index(std::uint32_t surface) const {
    return parts[triangle_part[surface]].material;
  }
  [[nodiscard]] const Material& material_of(std::uint32_t triangle) const {
    return materials[material_index(triangle)];
  }
};

/// The defocusing ratios of a world's materials, by index in World::materials; none: blurred by
/// roughness.
using MaterialDfrs = std::vector<std::optional<Dfr>>;

/// Returns the materials' own ratios.
[[nodiscard]] MaterialDfrs dfrs_of(const World& world);

/// A flattened scene: its surfaces, and its lights relative to World::origin.
struct FlattenedScene {
  World world;
  std::vector<Light> lights;
};

/// Returns the memory of a world's geometry, without textures.
[[nodiscard]] std::size_t geometry_bytes(const World& world);

/// Numbers the triangles and vertices of places, whose parts have sizes.
void number_places(Placements& placed, const std::vector<Part>& parts);

/// Returns the world without the parts whose flags are set; `hidden` has one for each of the first
/// parts, which have surfaces. The others keep their surfaces (Part::surfaces). Lines and points
/// must not be drawn.
[[nodiscard]] World without_parts(const World& world, std::span<const std::uint8_t> hidden);

/// Returns the world without the parts of placed meshes, whose entries stay and are empty.
[[nodiscard]] World without_placements(const World& world);

/// The default limit of `flatten`.
inline constexpr std::uint64_t most_triangles = 60'000'000;
/// A mesh is stored once if copies for its instances would have at least this many triangles.
inline constexpr std::uint64_t fewest_copied_triangles = 100'000;
inline constexpr std::uint64_t never_shared = ~std::uint64_t{0};

/// Flattens `scene`. Shapes become faces, except boxes, emitters and shapes without an inverse
/// matrix, which become triangles. Errors: more triangles than `max_triangles`, or positions that
/// do not fit a float. Zero-area triangles are kept: rays miss them, and their edges are no
/// boundaries. `origin` replaces the one that suits the positions best. Meshes whose copies would
/// have `fewest_copied` triangles or more are stored once (Placements).
[[nodiscard]] Result<FlattenedScene> flatten(const Scene& scene,
                                             std::uint64_t max_triangles = most_triangles,
                                             std::optional<glm::dvec3> origin = std::nullopt,
                                             std::uint64_t fewest_copied = fewest_copied_triangles);

/// Returns a camera that frames all of `world`, for files without cameras: from front, right and
/// above.
[[nodiscard]] Camera default_camera(const World& world, double aspect_ratio);

}  // namespace asos
