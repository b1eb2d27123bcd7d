#pragma once

#include "renderer/geometry/camera.h"
#include "renderer/geometry/shape.h"
#include "renderer/scene/contents.h"
#include "renderer/scene/shared_bytes.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// A scene as an author wrote it: meshes placed by instances, materials, lights and cameras. Plain
// data; the importer and the built-in scenes fill it, the exporter writes it, `World` flattens it.
// Conventions are glTF's: right-handed, +Y up, metres, radians; colours linear.

namespace asos {

/// 8-bit RGBA, rows from top to bottom, `4 * width * height` bytes. Whether the red, green and blue
/// bytes are sRGB-encoded is decided by what the image is used for, as in glTF.
struct Image {
  std::string name;
  int width = 0;
  int height = 0;
  SharedBytes rgba;
  /// The lower bytes of texels of 16 bits, whose upper ones `rgba` has; empty: texels of 8 bits.
  SharedBytes low{};
};

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter { nearest, linear };

struct Texture {
  std::string name;
  int image = -1;  ///< index into Scene::images
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter filter = Filter::linear;  ///< glTF's magFilter
};

/// A material's use of a texture. `uv_transform * (u, v, 1)` gives the coordinates to look up
/// (KHR_texture_transform); `scale` is the normal map's or the occlusion's strength.
struct TextureUse {
  int texture = -1;  ///< index into Scene::textures; -1: none
  int texcoord = 0;  ///< which set: 0 or 1
  glm::mat3 uv_transform{1.0f};
  float scale = 1.0f;

  [[nodiscard]] bool used() const { return texture >= 0; }
  /// Whether both show the same place of the same texture.
  [[nodiscard]] bool same_place(const TextureUse& other) const {
    return texture == other.texture && texcoord == other.texcoord &&
           uv_transform == other.uv_transform;
  }
  bool operator==(const TextureUse&) const = default;
};

enum class AlphaMode { opaque, mask, blend };

/// How blurred reflections are by their angle of incidence (CGF'98 section 5.1): the defocusing
/// ratio is min + (max - min) * sin(alpha)^exponent, of which 1 is a mirror and smaller is blurred.
struct DfrCurve {
  double min = 1.0;       ///< DFRMIN, 0 to 1
  double max = 1.0;       ///< DFRMAX, 0 to 1; may be less than min
  double exponent = 1.0;  ///< N, at least 0

  bool operator==(const DfrCurve&) const = default;
};

/// The curves of red, green and blue, and by how much each is perturbed from place to place: a
/// surface's unevenness, as a share of the ratio, 0 to 1.
struct Dfr {
  std::array<DfrCurve, 3> rgb;
  double perturbation = 0.0;

  bool operator==(const Dfr&) const = default;
};

/// KHR_materials_clearcoat: a clear layer of index 1.5 over all else, with a lobe of its own.
struct Clearcoat {
  float factor = 0.0f;  ///< 0 to 1; 0: there is none
  float roughness = 0.0f;
  TextureUse texture;            ///< R of `factor`, linear
  TextureUse roughness_texture;  ///< G, linear
  TextureUse normal_texture;     ///< its own: the material's normal map is not the coat's

  bool operator==(const Clearcoat&) const = default;
};

/// KHR_materials_sheen: fibres that stand on the surface and shine where they are seen from the
/// side (Charlie's distribution).
struct Sheen {
  glm::vec3 color{0.0f};  ///< linear, 0 to 1; black: there is none
  float roughness = 0.0f;
  TextureUse color_texture;      ///< sRGB
  TextureUse roughness_texture;  ///< A, linear

  [[nodiscard]] bool used() const { return color != glm::vec3(0.0f); }
  bool operator==(const Sheen&) const = default;
};

/// KHR_materials_iridescence: a thin film on the base, whose two sides' reflections interfere.
struct Iridescence {
  float factor = 0.0f;  ///< 0 to 1; 0: there is none
  float ior = 1.3f;
  float thickness_min_nm = 100.0f;
  float thickness_max_nm = 400.0f;  ///< where there is no texture
  TextureUse texture;               ///< R of `factor`, linear
  TextureUse thickness_texture;     ///< G, linear: from the minimum to the maximum

  [[nodiscard]] bool used() const { return factor > 0.0f; }
  bool operator==(const Iridescence&) const = default;
};

/// KHR_materials_anisotropy: the lobe is rougher along a direction of the surface, so that
/// highlights are drawn out as those of brushed metal are.
struct Anisotropy {
  float strength = 0.0f;      ///< 0 to 1; 0: there is none
  float rotation_rad = 0.0f;  ///< of that direction, counter-clockwise from the tangent
  TextureUse texture;         ///< RG: the direction before that, B of `strength`, linear

  [[nodiscard]] bool used() const { return strength > 0.0f; }
  bool operator==(const Anisotropy&) const = default;
};

/// KHR_materials_volume and KHR_materials_dispersion: what a closed surface that transmits
/// encloses.
struct Volume {
  float thickness = 0.0f;        ///< in the mesh's units; 0: a thin wall, which encloses nothing
  TextureUse thickness_texture;  ///< G, linear
  float attenuation_distance = std::numeric_limits<float>::infinity();  ///< in the world's units
  glm::vec3 attenuation_color{1.0f};  ///< linear: what white light becomes over that distance
  float dispersion = 0.0f;            ///< 20 / Abbe number, 0 and more

  bool operator==(const Volume&) const = default;
};

/// KHR_materials_diffuse_transmission: the share of what is not reflected by the lobe that goes
/// through the surface, all ways alike, instead of back.
struct DiffuseTransmission {
  float factor = 0.0f;       ///< 0 to 1
  glm::vec3 color{1.0f};     ///< linear, 0 to 1
  TextureUse texture;        ///< A of `factor`, linear
  TextureUse color_texture;  ///< sRGB

  [[nodiscard]] bool used() const { return factor > 0.0f; }
  bool operator==(const DiffuseTransmission&) const = default;
};

/// glTF 2.0 metallic-roughness, with the extensions that the renderer knows. Factors are linear.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;  ///< RGB sRGB, A linear
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;  ///< G roughness, B metallic, linear
  TextureUse normal_texture;              ///< tangent space, linear
  TextureUse occlusion_texture;    ///< R, linear: share of the open sky; `scale`: its strength
  glm::vec3 emissive{0.0f};        ///< times emissive_strength: nits
  float emissive_strength = 1.0f;  ///< KHR_materials_emissive_strength
  TextureUse emissive_texture;     ///< sRGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  ///< KHR_materials_unlit
  /// The material of lines or points (glTF 2.0, section 3.9.7). Without normals they are unlit and
  /// show their emission, too; with normals they are lit by these, however their ribbons face.
  bool stroke = false;
  float ior = 1.5f;                ///< KHR_materials_ior
  float transmission = 0.0f;       ///< KHR_materials_transmission
  float specular = 1.0f;           ///< KHR_materials_specular: of a dielectric's reflection, 0 to 1
  glm::vec3 specular_color{1.0f};  ///< the same, linear, at normal incidence; may exceed 1
  TextureUse specular_texture;     ///< A of `specular`, linear
  TextureUse specular_color_texture;  ///< sRGB
  TextureUse transmission_texture;    ///< R, linear
  Clearcoat coat;
  Sheen sheen;            ///< below the coat
  Iridescence film;       ///< below the sheen
  Anisotropy anisotropy;  ///< of the base's lobe
  Volume volume;
  DiffuseTransmission diffuse_transmission;
  std::optional<Dfr> dfr;  ///< how reflections are blurred; none: by roughness

  bool operator==(const Material&) const = default;
};

/// All textures that a material names, whether it uses them or not.
[[nodiscard]] inline std::array<const TextureUse*, 19> texture_uses(const Material& m) {
  return {&m.base_color_texture,
          &m.metallic_roughness_texture,
          &m.normal_texture,
          &m.emissive_texture,
          &m.specular_texture,
          &m.specular_color_texture,
          &m.transmission_texture,
          &m.coat.texture,
          &m.coat.roughness_texture,
          &m.coat.normal_texture,
          &m.sheen.color_texture,
          &m.sheen.roughness_texture,
          &m.film.texture,
          &m.film.thickness_texture,
          &m.occlusion_texture,
          &m.volume.thickness_texture,
          &m.diffuse_transmission.texture,
          &m.diffuse_transmission.color_texture,
          &m.anisotropy.texture};
}

/// Whether the surface is the boundary of a volume: rays that pass it are bent, and meet both of
/// its sides (KHR_materials_volume).
[[nodiscard]] inline bool bounds_volume(const Material& m) {
  return !m.unlit && m.transmission > 0.0f && m.volume.thickness > 0.0f;
}

/// Whether a thin wall blurs what is seen through it (KHR_materials_transmission); where a texture
/// says how rough it is, only in part.
[[nodiscard]] inline bool is_frosted(const Material& m) {
  return !m.unlit && m.transmission > 0.0f && !(m.volume.thickness > 0.0f) && m.roughness > 0.0f;
}

/// Whether its back is met as its front is.
[[nodiscard]] inline bool shows_both_sides(const Material& m) {
  return m.double_sided || bounds_volume(m);
}

[[nodiscard]] inline bool has_normal_map(const Material& m) {
  return m.normal_texture.used() || m.coat.normal_texture.used();
}

/// Whether it needs to know along which direction of the surface a texture's u grows.
[[nodiscard]] inline bool needs_tangents(const Material& m) {
  return has_normal_map(m) || m.anisotropy.used();
}

/// One primitive's triangles, or its lines or points, in its own space. Attribute arrays are empty
/// or as long as `positions`; every index is below that length; positions and normals are finite.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< unit; filled by the importer where the file has none
  std::vector<glm::vec4> tangents;  ///< xyz unit, w = +-1; only where needs_tangents
  std::vector<glm::vec2> texcoords[2];
  std::vector<glm::vec4> colors;  ///< linear RGBA
  std::vector<glm::uvec3> triangles;
  std::vector<glm::uvec2> segments;   ///< of LINES, LINE_STRIP and LINE_LOOP
  std::vector<std::uint32_t> points;  ///< of POINTS
  int material = -1;                  ///< index into Scene::materials; -1: glTF's default material

  [[nodiscard]] bool has_strokes() const { return !segments.empty() || !points.empty(); }
};

/// A mesh placed in the world. A negative determinant mirrors it. Where it is a shape, the shape is
/// drawn and the mesh is not: it has the material, and stands for the shape in programs that know
/// none.
struct Instance {
  std::string name;
  int mesh = -1;  ///< index into Scene::meshes
  glm::dmat4 world_from_mesh{1.0};
  bool shows_light = false;  ///< an emissive stand-in for a light of the scene: not a light itself
  int shape = -1;            ///< index into Scene::shapes; -1: none
  int node = -1;             ///< index into SceneContents::nodes; -1: none
};

/// A light, already placed in the world. Its encoding in files: gltf/LIGHTS.md. It has no
/// surface of its own: what a viewer sees of a lamp is an instance with an emissive material.
struct Light {
  enum class Type { point, spot, directional, linear, rectangle, disk, polygon };

  std::string name;
  Type type = Type::point;
  glm::vec3 color{1.0f};
  /// Candela (point, spot; linear: of the whole, seen square on), lux (directional: of a surface
  /// that faces it) or nits (rectangle, disk, polygon).
  float intensity = 1.0f;
  glm::dvec3 position{0.0};        ///< its middle; polygon: any point of its plane
  glm::dvec3 direction{0, 0, -1};  ///< unit, the way the light travels; flat lights shine that way
  double range = std::numeric_limits<double>::infinity();  ///< point and spot
  double inner_cone_rad = 0.0;                             ///< spot
  double outer_cone_rad = 0.7853981633974483;
  double radius = 0.0;                ///< disk; point and spot: of a ball that shines, 0: a point
  double angular_diameter_rad = 0.0;  ///< directional: of a sun's disk, 0: infinitely far point
  glm::dvec3 half_u{
      0.0};  ///< rectangle, linear: from the middle to the middle of a side, or an end
  glm::dvec3 half_v{0.0};  ///< rectangle: square to half_u and direction
  /// Polygon: closed outlines in one plane, the last corner joined to the first. The outer one runs
  /// counter-clockwise and holes clockwise as seen by who looks against `direction`.
  std::vector<std::vector<glm::dvec3>> outlines;
  bool two_sided = false;  ///< rectangle, disk, polygon: shines both ways
  bool casts_shadows = true;
  /// Index into World::parts of the surface that shines this light, which does not shade it; -1:
  /// none. Only in a World.
  std::int32_t own_part = -1;

  bool operator==(const Light&) const = default;
};

/// The parts of the file that are not drawn or not supported, in words for a person.
struct SceneNotes {
  std::vector<std::string> warnings;                ///< repaired or ignored, with the reason
  std::uint64_t warnings_dropped = 0;               ///< that the last of them counts
  std::vector<std::string> unsupported_extensions;  ///< optional ones that are not honoured
  std::vector<std::string> not_shown;               ///< parts that another choice would show
};

class Rig;
struct Surroundings;

struct Scene {
  std::string name;    ///< of the glTF scene, or the built-in scene
  std::string source;  ///< path, or "builtin:NAME"
  std::vector<Mesh> meshes;
  std::vector<Shape> shapes;
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::shared_ptr<const Surroundings> surroundings;  ///< EXT_lights_image_based; null: none
  SceneNotes notes;
  SceneContents contents;
  std::optional<ClipTime> time;  ///< of what moves; none: everything is where its nodes place it
  std::shared_ptr<Rig> rig;  ///< poses the scene at other times; null: nothing moves, or not kept

  /// The triangles of all instances: a box has 12, other shapes none.
  [[nodiscard]] std::uint64_t instanced_triangles() const;
  /// Whether an instance shows a surface, and not only lines and points or nothing.
  [[nodiscard]] bool shows_surface(const Instance& instance) const {
    return instance.shape >= 0 ||
           (instance.mesh >= 0 &&
            !meshes[static_cast<std::size_t>(instance.mesh)].triangles.empty());
  }
  /// The segments of lines, and the points, of all instances.
  [[nodiscard]] std::uint64_t instanced_segments() const;
  [[nodiscard]] std::uint64_t instanced_points() const;
};

}  // namespace asos
