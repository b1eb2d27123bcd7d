#pragma once

#include "renderer/geometry/box.h"
#include "renderer/geometry/shape_face.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/world/strokes.h"

#include <glm/glm.hpp>

#include <cstdint>
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
struct World {
  glm::dvec3 origin{0.0};
  std::vector<glm::vec3> positions;          ///< capacity for one more saves the rays a copy
  std::vector<glm::vec3> normals;            ///< unit, one a vertex
  std::vector<glm::vec4> tangents;           ///< or empty; 0 for meshes that have none of their own
  std::vector<glm::vec2> texcoords[2];       ///< or empty
  std::vector<glm::vec4> colors;             ///< linear RGBA, or empty
  std::vector<glm::uvec3> triangles;         ///< into positions
  std::vector<ShapeFace> faces;              ///< of analytic shapes
  std::vector<std::uint32_t> triangle_part;  ///< the part of each triangle, then of each face
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

/// What `flatten` refuses by default.
inline constexpr std::uint64_t most_triangles = 60'000'000;

/// Flattens `scene`. Shapes become faces, but for boxes and for what shines or has no inverse,
/// which become triangles. Refuses a scene with more triangles than `max_triangles`, and one whose
/// placed positions do not fit a float. Zero-area triangles are kept: rays miss them, and their
/// edges bound nothing. `origin`: that of the world, in place of one that suits its positions best.
[[nodiscard]] Result<FlattenedScene> flatten(const Scene& scene,
                                             std::uint64_t max_triangles = most_triangles,
                                             std::optional<glm::dvec3> origin = std::nullopt);

/// The camera that frames all of `world` when the file has none: from front, right and above.
[[nodiscard]] Camera default_camera(const World& world, double aspect_ratio);

}  // namespace asos
