#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace asos::builtin {

/// Assembles a built-in scene. Colours are 0xRRGGBB in sRGB. Brightness: a white diffuse surface
/// under an illuminance of pi lux has radiance 1, which is display white at exposure 0. So suns
/// have 2 to 3 lux; the candela of lamps and the nits of panels give about as much at the subject.
/// There is no ambient light. Each scene has a weak fill light, from the sky or from near the
/// camera, where the subject hides the fill's shadows.
class SceneAssembler {
 public:
  explicit SceneAssembler(const std::string& name);

  int paint(const std::string& name, std::uint32_t srgb, float roughness = 0.8f,
            float metallic = 0.0f);
  /// A surface that emits `nits` times its colour and reflects nothing.
  int glow(const std::string& name, std::uint32_t srgb, float nits);
  void make_double_sided(int material) { scene_.materials[material].double_sided = true; }
  /// Returns the first material that was painted under this name, which must exist. For variants of
  /// scenes with other materials.
  [[nodiscard]] Material& material(std::string_view name);
  /// Keeps an image as a texture, and returns its index for a material. `wrap` applies beyond the
  /// image's sides.
  int keep_texture(Image image, Wrap wrap = Wrap::repeat);
  /// Makes a texture the colour of the material of this name, and gives the flat-shaded meshes of
  /// the material texture coordinates. The image covers squares of side `metres`.
  void cover(std::string_view material, int texture, float metres);

  /// Keeps a mesh for one or more instances, and returns its index for `place`.
  int keep(const std::string& name, Mesh mesh, int material);
  void place(const std::string& name, int mesh, const glm::dmat4& world_from_mesh);
  /// Keeps a mesh that is built in world coordinates and places it there.
  void add(const std::string& name, Mesh mesh, int material);
  /// Places an analytic shape.
  void add(const std::string& name, const Shape& shape, const glm::dmat4& world_from_shape,
           int material);
  /// Marks the last instance as the visible surface of a light. It emits no light itself.
  void show_light() { scene_.instances.back().shows_light = true; }

  /// `travel`: the direction in which the light travels; any length. `diameter_rad`: of the sun's
  /// disk in the sky, 0 for light from a single direction.
  void sun(const std::string& name, glm::dvec3 travel, std::uint32_t srgb, float lux,
           double diameter_rad = 0.0);
  void lamp(const std::string& name, glm::dvec3 position, std::uint32_t srgb, float candela);
  void spot(const std::string& name, glm::dvec3 position, glm::dvec3 target, std::uint32_t srgb,
            float candela, double outer_cone_deg);
  /// A spherical lamp; radius in metres.
  void ball(const std::string& name, glm::dvec3 position, double radius, std::uint32_t srgb,
            float candela);
  /// A straight tube between two ends; `candela` is the intensity of the whole tube seen from its
  /// side.
  void tube(const std::string& name, glm::dvec3 from, glm::dvec3 to, std::uint32_t srgb,
            float candela);
  /// A rectangle around `centre`, with `size.x` along the horizontal and `size.y` along the
  /// vertical, which emits towards `target` only. One that faces straight up or down has its width
  /// along x.
  void panel(const std::string& name, glm::dvec3 centre, glm::dvec3 target, glm::dvec2 size,
             std::uint32_t srgb, float nits);
  /// The soft counterpart of a sun: a square panel at `distance` from `target` against `travel`.
  /// Its side is 0.3 of the distance, so the width of a penumbra is 0.3 of the distance from the
  /// edge to its shadow. It gives `lux` at the target on a surface that faces it.
  void soft_sun(const std::string& name, glm::dvec3 target, glm::dvec3 travel, double distance,
                std::uint32_t srgb, float lux);

  /// Makes the existing lights cast no shadows.
  void cast_no_shadows();

  /// An upright perspective camera; fov is the full vertical angle.
  void camera(const std::string& name, glm::dvec3 eye, glm::dvec3 target, double fov_y_deg);

  [[nodiscard]] Scene take() { return std::move(scene_); }

 private:
  void add_light(Light light, const std::string& name, std::uint32_t srgb);

  Scene scene_;
};

/// Returns the illuminance, in lux, of a rectangle of `size` and one nit on a surface that faces
/// it, at `distance` in front of its centre: the closed form of the projected solid angle.
[[nodiscard]] double illuminance_before(glm::dvec2 size, double distance);

/// Returns the use of a texture with coordinates in metres, whose image covers squares of this
/// side.
[[nodiscard]] TextureUse by_metres(int texture, float metres);

/// A sun's diameter in the sky, as seen from the earth.
inline constexpr double sun_diameter_rad = 0.0093;

/// The placement that turns by `degrees` about +Y and then moves to `position`.
[[nodiscard]] glm::dmat4 turned(glm::dvec3 position, double degrees);

}  // namespace asos::builtin
