#pragma once

#include "renderer/geometry/box.h"
#include "renderer/geometry/shape_face.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/world/attribute.h"
#include "renderer/world/strokes.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos {

/// The consecutive triangles, or faces, of one instance: one object with one material.
struct Part {
  std::string name;
  std::uint32_t first_triangle = 0;
  std::uint32_t triangle_count = 0;
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t material = 0;    ///< index into World::materials, always valid
  bool shows_light = false;      ///< as Instance's
  bool coloured = false;         ///< a vertex of it has another colour than white
  Box bounds;                    ///< of the positions that its triangles use; empty: not known
  std::uint32_t face_count = 0;  ///< faces of an analytic shape; such a part has no triangles
  bool strokes = false;          ///< of lines or points, which are drawn for each picture

  [[nodiscard]] bool shows_nothing() const {
    return triangle_count == 0 && face_count == 0 && !strokes;
  }
};

/// A scene's surfaces flattened into one indexed triangle soup, placed in the world and recentred
/// in double precision (design section 10): `position + origin` is the author's coordinate.
/// Immutable once shared. Arrays of attributes that no material needs are empty (design section 8).
/// Large meshes with several instances are kept once (Placements); their triangles and vertices
/// come after all others.
struct World {
  glm::dvec3 origin{0.0};
  Attribute<glm::vec3> positions;          ///< capacity for one more saves the rays a copy
  Attribute<glm::vec3> normals;            ///< unit, one a vertex
  Attribute<glm::vec4> tangents;           ///< or empty; 0 for meshes that have none of their own
  Attribute<glm::vec2> texcoords[2];       ///< or empty
  Attribute<glm::vec4> colors;             ///< linear RGBA, or empty
  Attribute<glm::uvec3> triangles;         ///< into positions
  std::vector<ShapeFace> faces;            ///< of analytic shapes; none with placed meshes
  Attribute<std::uint32_t> triangle_part;  ///< the part of each triangle, then of each face
  std::shared_ptr<const Placements> placements;  ///< see set_placements; null: none
  bool flat = false;  ///< of a shared mesh: it has no normals, and three vertices a triangle
  std::vector<Part> parts;
  /// The scene's, then glTF's default material, then those that lines and points have.
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Camera> cameras;  ///< relative to origin
  Box bounds;                   ///< of the positions that triangles use; empty if none
  Strokes strokes;              ///< the lines and points

  /// Every surface that a ray meets has one number: a triangle's index, or that of a face of an
  /// analytic shape behind them all.
  [[nodiscard]] bool is_face(std::uint32_t surface) const { return surface >= triangles.size(); }
  [[nodiscard]] const ShapeFace& face(std::uint32_t surface) const {
    return faces[surface - triangles.size()];
  }
  [[nodiscard]] std::uint32_t surface_count() const {
    return static_cast<std::uint32_t>(triangles.size() + faces.size());
  }
  /// The parts that are not of lines and points come first.
  [[nodiscard]] std::size_t solid_parts() const {
    return strokes.empty() ? parts.size() : strokes.first_part;
  }
  /// So do the triangles that are not of lines and points.
  [[nodiscard]] std::size_t solid_triangles() const {
    return triangles.size() - strokes.triangle_count;
  }
  /// Whether a picture can show anything of it.
  [[nodiscard]] bool shows_nothing() const { return surface_count() == 0 && strokes.empty(); }

  /// Whether a triangle is one of a mesh that is kept once for several instances.
  [[nodiscard]] bool is_placed(std::uint32_t triangle) const {
    return placements && triangle >= triangles.own().size();
  }
  /// Shows meshes in many places, after all that the world has of its own, which may have grown
  /// since they were set last. Null: none.
  void set_placements(std::shared_ptr<const Placements> placed);

  /// The index of a surface's material in `materials`.
  [[nodiscard]] std::uint32_t material_index(std::uint32_t surface) const {
    return parts[triangle_part[surface]].material;
  }
  [[nodiscard]] const Material& material_of(std::uint32_t triangle) const {
    return materials[material_index(triangle)];
  }
};

/// How each material of a world blurs what it mirrors, by index in World::materials; none: by its
/// roughness.
using MaterialDfrs = std::vector<std::optional<Dfr>>;

/// The materials' own.
[[nodiscard]] MaterialDfrs dfrs_of(const World& world);

/// A scene after flattening: its surfaces, and its lights relative to World::origin.
struct FlattenedScene {
  World world;
  std::vector<Light> lights;
};

/// The memory of a world's geometry, without textures.
[[nodiscard]] std::size_t geometry_bytes(const World& world);

/// The same world without the parts of placed meshes, whose entries stay and are empty.
[[nodiscard]] World without_placements(const World& world);

/// What `flatten` refuses by default.
inline constexpr std::uint64_t most_triangles = 60'000'000;
/// A mesh is kept once where copies for its instances would have so many triangles.
inline constexpr std::uint64_t fewest_copied_triangles = 100'000;
inline constexpr std::uint64_t never_shared = ~std::uint64_t{0};

/// Flattens `scene`. Shapes become faces, but for boxes and for what shines or has no inverse,
/// which become triangles. Refuses a scene with more triangles than `max_triangles`, and one whose
/// placed positions do not fit a float. Zero-area triangles are kept: rays miss them, and their
/// edges bound nothing. `origin`: that of the world, in place of one that suits its positions best.
/// Meshes whose copies would have `fewest_copied` triangles or more are kept once (Placements).
[[nodiscard]] Result<FlattenedScene> flatten(const Scene& scene,
                                             std::uint64_t max_triangles = most_triangles,
                                             std::optional<glm::dvec3> origin = std::nullopt,
                                             std::uint64_t fewest_copied = fewest_copied_triangles);

/// The camera that frames all of `world` when the file has none: from front, right and above.
[[nodiscard]] Camera default_camera(const World& world, double aspect_ratio);

}  // namespace asos
