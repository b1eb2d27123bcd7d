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

// A scene in its authored form: meshes placed by instances, materials, lights and cameras. Plain
// data: the importer and the built-in scenes fill it, the exporter writes it, and `World` flattens
// it. Conventions are glTF's: right-handed, +Y up, metres, radians; colours linear.

namespace asos {

/// 8-bit RGBA, rows from top to bottom, `4 * width * height` bytes. The use of the image determines
/// if red, green and blue are sRGB-encoded, as in glTF.
struct Image {
  std::string name;
  int width = 0;
  int height = 0;
  SharedBytes rgba;
  /// The low bytes of 16-bit texels; `rgba` holds the high bytes. Empty: 8-bit texels.
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

/// A material's use of a texture. `uv_transform * (u, v, 1)` are the coordinates of the lookup
/// (KHR_texture_transform); `scale` is the normal map's or the occlusion's strength.
struct TextureUse {
  int texture = -1;  ///< index into Scene::textures; -1: none
  int texcoord = 0;  ///< which set: 0 or 1
  glm::mat3 uv_transform{1.0f};
  float scale = 1.0f;

  [[nodiscard]] bool used() const { return texture >= 0; }
  /// Returns whether both map the same part of the same texture.
  [[nodiscard]] bool same_place(const TextureUse& other) const {
    return texture == other.texture && texcoord == other.texcoord &&
           uv_transform == other.uv_transform;
  }
  bool operator==(const TextureUse&) const = default;
};

enum class AlphaMode { opaque, mask, blend };

/// The blur of reflections as a function of the angle of incidence alpha (CGF'98 section 5.1). The
/// defocusing ratio is min + (max - min) * sin(alpha)^exponent; 1 is a mirror, and smaller ratios
/// blur.
struct DfrCurve {
  double min = 1.0;       ///< DFRMIN, 0 to 1
  double max = 1.0;       ///< DFRMAX, 0 to 1; may be less than min
  double exponent = 1.0;  ///< N, at least 0

  bool operator==(const DfrCurve&) const = default;
};

/// The defocusing curves of red, green and blue, and the amplitude of their random variation over
/// the surface, as a fraction of the ratio, 0 to 1.
struct Dfr {
  std::array<DfrCurve, 3> rgb;
  double perturbation = 0.0;

  bool operator==(const Dfr&) const = default;
};

/// KHR_materials_clearcoat: a clear layer of index 1.5 on top, with a lobe of its own.
struct Clearcoat {
  float factor = 0.0f;  ///< 0 to 1; 0: no coat
  float roughness = 0.0f;
  TextureUse texture;            ///< R scales `factor`, linear
  TextureUse roughness_texture;  ///< G, linear
  TextureUse normal_texture;     ///< the coat's own; the material's normal map does not affect it

  bool operator==(const Clearcoat&) const = default;
};

/// KHR_materials_sheen: fibres on the surface, which are brightest at grazing angles (Charlie
/// distribution).
struct Sheen {
  glm::vec3 color{0.0f};  ///< linear, 0 to 1; black: no sheen
  float roughness = 0.0f;
  TextureUse color_texture;      ///< sRGB
  TextureUse roughness_texture;  ///< A scales `roughness`, linear

  [[nodiscard]] bool used() const { return color != glm::vec3(0.0f); }
  bool operator==(const Sheen&) const = default;
};

/// KHR_materials_iridescence: a thin film on the base; the reflections from its two sides
/// interfere.
struct Iridescence {
  float factor = 0.0f;  ///< 0 to 1; 0: no film
  float ior = 1.3f;
  float thickness_min_nm = 100.0f;
  float thickness_max_nm = 400.0f;  ///< used if there is no texture
  TextureUse texture;               ///< R scales `factor`, linear
  TextureUse thickness_texture;     ///< G, linear: from the minimum to the maximum

  [[nodiscard]] bool used() const { return factor > 0.0f; }
  bool operator==(const Iridescence&) const = default;
};

/// KHR_materials_anisotropy: the lobe is rougher along one direction of the surface, so that
/// highlights are elongated as on brushed metal.
struct Anisotropy {
  float strength = 0.0f;      ///< 0 to 1; 0: isotropic
  float rotation_rad = 0.0f;  ///< of the rougher direction, counter-clockwise from the tangent
  TextureUse texture;         ///< RG: direction before the rotation, B scales `strength`; linear

  [[nodiscard]] bool used() const { return strength > 0.0f; }
  bool operator==(const Anisotropy&) const = default;
};

/// KHR_materials_volume and KHR_materials_dispersion: the medium inside a closed surface that
/// transmits.
struct Volume {
  float thickness = 0.0f;        ///< in the mesh's units; 0: a thin wall without a volume
  TextureUse thickness_texture;  ///< G, linear
  float attenuation_distance = std::numeric_limits<float>::infinity();  ///< in the world's units
  glm::vec3 attenuation_color{1.0f};  ///< linear: transmittance over that distance
  float dispersion = 0.0f;            ///< 20 / Abbe number, 0 and more

  bool operator==(const Volume&) const = default;
};

/// KHR_materials_diffuse_transmission: the fraction of the light not reflected by the lobe that is
/// transmitted diffusely instead of reflected diffusely.
struct DiffuseTransmission {
  float factor = 0.0f;       ///< 0 to 1
  glm::vec3 color{1.0f};     ///< linear, 0 to 1
  TextureUse texture;        ///< A scales `factor`, linear
  TextureUse color_texture;  ///< sRGB

  [[nodiscard]] bool used() const { return factor > 0.0f; }
  bool operator==(const DiffuseTransmission&) const = default;
};

/// glTF 2.0 metallic-roughness, with the supported extensions. Factors are linear.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;  ///< RGB sRGB, A linear
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;  ///< G roughness, B metallic, linear
  TextureUse normal_texture;              ///< tangent space, linear
  TextureUse occlusion_texture;           ///< R, linear: ambient visibility; `scale`: its strength
  glm::vec3 emissive{0.0f};               ///< times emissive_strength: nits
  float emissive_strength = 1.0f;         ///< KHR_materials_emissive_strength
  TextureUse emissive_texture;            ///< sRGB
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  ///< KHR_materials_unlit
  /// The material of lines or points (glTF 2.0, section 3.9.7). Without normals they are unlit and
  /// also show their emission. With normals they are lit by these, independent of the orientation
  /// of their ribbons.
  bool stroke = false;
  float ior = 1.5f;                ///< KHR_materials_ior
  float transmission = 0.0f;       ///< KHR_materials_transmission
  float specular = 1.0f;           ///< KHR_materials_specular: scales dielectric reflection, 0 to 1
  glm::vec3 specular_color{1.0f};  ///< scales it at normal incidence, linear; may exceed 1
  TextureUse specular_texture;     ///< A scales `specular`, linear
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

/// Returns all textures that a material refers to, whether it uses them or not.
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

/// Returns whether the surface is the boundary of a volume (KHR_materials_volume): it refracts
/// rays, and both of its sides are hit.
[[nodiscard]] inline bool bounds_volume(const Material& m) {
  return !m.unlit && m.transmission > 0.0f && m.volume.thickness > 0.0f;
}

/// Returns whether a thin wall blurs the transmitted view (KHR_materials_transmission). If a
/// texture scales the roughness, parts of the wall may be clear.
[[nodiscard]] inline bool is_frosted(const Material& m) {
  return !m.unlit && m.transmission > 0.0f && !(m.volume.thickness > 0.0f) && m.roughness > 0.0f;
}

/// Returns whether rays hit a surface's back as well as its front.
[[nodiscard]] inline bool shows_both_sides(const Material& m) {
  return m.double_sided || bounds_volume(m);
}

[[nodiscard]] inline bool has_normal_map(const Material& m) {
  return m.normal_texture.used() || m.coat.normal_texture.used();
}

/// Returns whether shading needs the direction of a texture's u axis on the surface.
[[nodiscard]] inline bool needs_tangents(const Material& m) {
  return has_normal_map(m) || m.anisotropy.used();
}

/// The triangles, lines or points of one primitive, in its own space. Attribute arrays are empty or
/// as long as `positions`; every index is below that length; positions and normals are finite.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< unit; the importer adds missing ones
  std::vector<glm::vec4> tangents;  ///< xyz unit, w = +-1; only where needs_tangents
  std::vector<glm::vec2> texcoords[2];
  std::vector<glm::vec4> colors;  ///< linear RGBA
  std::vector<glm::uvec3> triangles;
  std::vector<glm::uvec2> segments;   ///< of LINES, LINE_STRIP and LINE_LOOP
  std::vector<std::uint32_t> points;  ///< of POINTS
  int material = -1;                  ///< index into Scene::materials; -1: glTF's default material

  [[nodiscard]] bool has_lines() const { return !segments.empty() || !points.empty(); }
};

/// A mesh placed in the world. A negative determinant mirrors it. If there is a shape, it is drawn
/// instead of the mesh. The mesh then defines the material, and replaces the shape in programs that
/// do not support shapes.
struct Instance {
  std::string name;
  int mesh = -1;  ///< index into Scene::meshes
  glm::dmat4 world_from_mesh{1.0};
  bool shows_light = false;  ///< the visible surface of a light of the scene; emits no light itself
  int shape = -1;            ///< index into Scene::shapes; -1: none
  int node = -1;             ///< index into SceneContents::nodes; -1: none
  int primitive = -1;        ///< of the node's glTF mesh; -1: the node's shape, or none
};

/// A light, placed in the world. gltf/LIGHTS.md describes its encoding in files. It has no surface
/// of its own: the visible part of a lamp is an instance with an emissive material.
struct Light {
  enum class Type { point, spot, directional, linear, rectangle, disk, polygon };

  std::string name;
  Type type = Type::point;
  glm::vec3 color{1.0f};
  /// Candela (point, spot; linear: of the whole tube, perpendicular to it), lux (directional: on a
  /// surface that faces it) or nits (rectangle, disk, polygon).
  float intensity = 1.0f;
  glm::dvec3 position{0.0};        ///< its centre; polygon: any point of its plane
  glm::dvec3 direction{0, 0, -1};  ///< unit, the way the light travels; flat lights shine that way
  double range = std::numeric_limits<double>::infinity();  ///< point and spot
  double inner_cone_rad = 0.0;                             ///< spot
  double outer_cone_rad = 0.7853981633974483;
  /// Disk. Point and spot: of an emitting ball; 0: a point. Linear: of a tube with round ends about
  /// the line, whose intensity is that of the line; 0: a line.
  double radius = 0.0;
  double angular_diameter_rad = 0.0;  ///< directional: of a sun's disk, 0: infinitely far point
  /// Rectangle, linear: from the centre to the centre of a side, or to an end.
  glm::dvec3 half_u{0.0};
  glm::dvec3 half_v{0.0};  ///< rectangle: perpendicular to half_u and direction
  /// Polygon: closed outlines in one plane, the last corner joined to the first. The outer one runs
  /// counter-clockwise and holes clockwise, as seen against `direction`.
  std::vector<std::vector<glm::dvec3>> outlines;
  bool two_sided = false;  ///< rectangle, disk, polygon: emits from both sides
  bool casts_shadows = true;
  /// Index into World::parts of the light's own surface, which does not shadow it; -1: none. Only
  /// in a World.
  std::int32_t own_part = -1;

  bool operator==(const Light&) const = default;
};

/// The parts of the file that are not drawn or not supported, in words for the user.
struct SceneNotes {
  std::vector<std::string> warnings;                ///< repaired or ignored, with the reason
  std::uint64_t warnings_dropped = 0;               ///< their number is in the last warning
  std::vector<std::string> unsupported_extensions;  ///< optional ones that are ignored
  /// Parts that another choice of the user would show.
  std::vector<std::string> not_shown;
};

/// The lighting that the program adds to a scene.
enum class AddedLighting {
  automatic,    ///< lights, environment and ground, if the scene itself has almost no light
  environment,  ///< environment and ground; the user chose the lights
  none
};

class PosableScene;
struct EnvironmentCube;

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
  std::shared_ptr<const EnvironmentCube> surroundings;  ///< EXT_lights_image_based; null: none
  AddedLighting added_lighting = AddedLighting::automatic;
  SceneNotes notes;
  SceneContents contents;
  std::optional<ClipTime> time;  ///< of the animation; none: the rest pose of the nodes
  std::shared_ptr<PosableScene>
      rig;  ///< poses the scene at other times; null: not animated, or not kept

  /// Returns the number of triangles of all instances: a box has 12, other shapes none.
  [[nodiscard]] std::uint64_t instanced_triangles() const;
  /// Returns whether an instance has a surface, and not only lines, points or nothing.
  [[nodiscard]] bool shows_surface(const Instance& instance) const {
    return instance.shape >= 0 ||
           (instance.mesh >= 0 &&
            !meshes[static_cast<std::size_t>(instance.mesh)].triangles.empty());
  }
  /// Returns the number of line segments, and of points, of all instances.
  [[nodiscard]] std::uint64_t instanced_segments() const;
  [[nodiscard]] std::uint64_t instanced_points() const;
};

}  // namespace asos
