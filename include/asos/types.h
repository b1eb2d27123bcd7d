#pragma once

#include "asos/export.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Plain data. Conventions are glTF's: right-handed, +Y up, metres, radians; colours are linear.

namespace asos::api {

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;
using Double3 = std::array<double, 3>;
/// An affine matrix of 4x4, column by column.
using Matrix4 = std::array<double, 16>;

inline constexpr Matrix4 identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Returns the matrix that moves the origin to `place`.
[[nodiscard]] constexpr Matrix4 translation(Double3 place) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, place[0], place[1], place[2], 1};
}

/// Pixels, x to the right and y down from the picture's top left corner.
struct Rect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const Rect&) const = default;
};

/// A camera that looks along -Z of `world_from_camera`, with +Y up; the matrix is rigid.
struct Camera {
  std::string name = {};
  bool perspective = true;  ///< else orthographic
  Matrix4 world_from_camera = identity;
  double fov_y_rad = 0.8726646259971648;  ///< perspective: full vertical angle, in (0, pi)
  double height = 1.0;                    ///< orthographic: full height, above 0
  /// Depths ahead of the eye. The picture shows nothing nearer or farther.
  std::optional<double> near_depth = {};
  std::optional<double> far_depth = {};
  double aperture_radius = 0.0;      ///< of a thin lens, in metres; 0: a pinhole
  std::optional<double> focus = {};  ///< depth of the focus plane; none: automatic
  int blades = 0;                    ///< corners of the aperture, 3 to 32; 0: a disk
  double blade_turn_rad = 0.0;       ///< counter-clockwise turn of the first corner from the right
  /// Width over height of the picture that the author had in mind; none: any. See `fitted`.
  std::optional<double> aspect_ratio = {};
  /// Number of the scene's camera whose motion it follows while the shutter is open; -1: it stands
  /// still. `Scene::cameras` sets it.
  int follows = -1;
};

/// How a camera with an aspect ratio is shown in a picture with another one (glTF 2.0, section
/// 3.10.3).
enum class CameraFit {
  crop,  ///< by height: a wider camera loses its sides
  fit,   ///< all of its view, and more
  fill   ///< nothing outside its view
};

/// Returns the camera for a picture of this aspect ratio (width over height): only `fov_y_rad`, or
/// `height`, changes.
[[nodiscard]] ASOS_API Camera fitted(const Camera& camera, double aspect_ratio,
                                     CameraFit fit = CameraFit::fit);

/// Returns `aperture_radius` of a scene in metres at f/`f_stop`, on a sensor that is 24 mm high.
[[nodiscard]] ASOS_API double aperture_of_f_stop(double f_stop, double fov_y_rad);

/// Returns a camera at `eye` that looks at `target`, with +Y up; for a vertical view -Z is up.
/// `fov_y_rad`: full vertical angle. Two equal points give a camera that `render` refuses.
[[nodiscard]] ASOS_API Camera look_at(Double3 eye, Double3 target, double fov_y_rad = 0.87266462);

enum class LightType { point, spot, directional, linear, rectangle, disk };

/// A light. It has no surface of its own.
struct Light {
  std::string name = {};
  LightType type = LightType::point;
  Float3 color{1, 1, 1};
  /// Candela (point, spot, linear), lux (directional) or nits (rectangle, disk).
  float intensity = 1.0f;
  Double3 position{0, 0, 0};    ///< its centre
  Double3 direction{0, 0, -1};  ///< the way the light travels; of any length above 0
  double range = std::numeric_limits<double>::infinity();  ///< point and spot, in metres
  double inner_cone_rad = 0.0;                             ///< spot: half angles
  double outer_cone_rad = 0.7853981633974483;
  /// Disk; point and spot: of a luminous ball, 0: a point; linear: of a tube with round ends, 0: a
  /// line.
  double radius = 0.0;
  double angular_diameter_rad = 0.0;  ///< directional: of the sun's disk
  Double3 half_u{0, 0, 0};  ///< rectangle, linear: from the centre to the middle of a side or end
  Double3 half_v{0, 0, 0};  ///< rectangle: perpendicular to half_u and direction
  bool two_sided = false;   ///< rectangle and disk
  bool casts_shadows = true;
};

/// A material of glTF's metallic-roughness model. Factors are 0 to 1 where nothing else is said.
struct Material {
  std::string name = {};
  Float4 base_color{1, 1, 1, 1};  ///< the fourth value is alpha, used by `blended`
  int base_color_image = -1;      ///< of SceneBuilder::add_image; -1: none
  float metallic = 0.0f;
  float roughness = 1.0f;
  Float3 emissive{0, 0, 0};  ///< nits, 0 and more
  float ior = 1.5f;          ///< 1 and more
  float transmission = 0.0f;
  float thickness = 0.0f;  ///< metres; above 0 the closed surface encloses a refracting volume
  bool blended = false;
  bool double_sided = false;
  bool unlit = false;
};

/// A triangle mesh in the caller's arrays, which are copied. Arrays are empty or have one entry a
/// vertex.
struct MeshData {
  std::string name = {};
  std::span<const float> positions = {};  ///< x, y, z of each vertex
  std::span<const float> normals = {};    ///< likewise, of any length above 0; empty: flat faces
  std::span<const float> texcoords = {};  ///< u, v of each vertex
  std::span<const float> colors = {};     ///< linear R, G, B, A of each vertex, 0 to 1
  std::span<const std::uint32_t> triangles =
      {};  ///< three vertices each, counter-clockwise in front
};

enum class ShapeType { sphere, disk, box, cylinder };

/// An analytic shape, centred at its origin, round about +Y. A cylinder with two radii is a
/// truncated cone. A disk faces +Y. Sizes are above 0; one radius of a cylinder may be 0.
struct Shape {
  ShapeType type = ShapeType::sphere;
  double radius = 0.5;    ///< sphere, disk
  Double3 size{1, 1, 1};  ///< box: full extents
  double height = 1.0;    ///< cylinder
  double radius_bottom = 0.5;
  double radius_top = 0.5;
};

}  // namespace asos::api
