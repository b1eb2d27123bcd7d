#pragma once

#include "renderer/film/light_parts.h"
#include "renderer/film/statistics.h"
#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/passed_layers.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/viewed_point.h"
#include "renderer/shading/volume_path.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <span>

namespace asos {

/// A ray whose radiance is computed, with the extent that it represents. It comes from the eye or
/// was reflected.
struct ViewedRay {
  Ray ray;            ///< unit direction
  Hit hit;            ///< its nearest hit; invalid: the background
  float side = 0.0f;  ///< side of the square around it, in pixels of `spacing`; 0: a point
  const PixelSpacing* spacing = nullptr;  ///< null: the spacing of eye rays
  /// Width of the pyray one unit ahead (2 tan(beta / 2)): that of a pixel, widened by the lobes of
  /// blurred reflections. A defocusing ratio multiplies it.
  float width = 0.0f;
  int bounces = 0;          ///< reflections and refractions on its way
  float throughput = 1.0f;  ///< largest factor of its radiance in the picture, over the colours
  /// Lights that emit evenly, and the surfaces with their geometry, are dark: the reflecting
  /// surface has highlights of them (MirroredLights).
  bool hides_lights = false;
  FootprintShape shape = {};  ///< shape of the part that it represents, relative to the square
  /// Includes only diffuse reflection, without emission. Used for rays that carry light to another
  /// surface, which samples the lights itself.
  bool diffuse = false;
  VolumePath passage = {};
  /// The parts that `shape` represents together. Colours are averaged over each of them; empty:
  /// `shape` is exact.
  std::span<const WeightedShape> parts = {};
  float colours = 1.0f;  ///< factor of the width over which colours are averaged
  PassedLayers passed = {};

  /// Returns the distance from which on its medium attenuates it.
  [[nodiscard]] float start() const {
    return passed.last == Hit::none ? ray.t_near : passed.distance;
  }
  /// Returns whether any surface has reflected it, instead of only transmitting it.
  [[nodiscard]] bool reflected() const { return bounces > passage.refractions; }
};

class Sky;

[[nodiscard]] inline Receiver receiver_at(const SurfacePoint& point) {
  return {glm::dvec3(point.lit_position()), glm::dvec3(point.shading_normal),
          glm::dvec3(point.horizon())};
}

/// The lights that are visible in a point's reflection. The lobe has no highlights of these.
enum class MirroredLights {
  none,       ///< none, or there is no reflection
  patterned,  ///< those whose surface emits unevenly
  all,        ///< all with a surface
};

/// A point and all lights that may illuminate it, before any of them is evaluated.
struct LightingQuery {
  std::span<const PreparedLight> lights;  ///< the same for all points of a picture
  const ViewedPoint& view;
  const ViewedMaterial& material;
  MirroredLights mirrored = MirroredLights::none;
  glm::vec3 share{1.0f};  ///< weight of the point's radiance in that of its ray
  bool shadows = true;    ///< whether lights cast shadows; the same for all points of a picture
};

/// A point that the sky may illuminate.
struct SkyQuery {
  const Sky* sky = nullptr;  ///< null: the neutral one
  const ViewedPoint& view;
  const ViewedMaterial& material;
  bool mirrors = false;   ///< a traced reflection replaces the specular lobe
  glm::vec3 share{1.0f};  ///< weight of the point's radiance in that of its ray
};

/// A light that illuminates a point, and the point's reflection of it.
struct Illumination {
  const PreparedLight& light;
  std::uint32_t index = 0;  ///< of the light in Lighting::lights
  const SurfacePoint& point;
  glm::vec3 unshadowed{0.0f};  ///< irradiance without occlusion
  glm::vec3 reflected{0.0f};   ///< radiance towards the viewer per irradiance
  int layer = 0;               ///< number of surfaces in front of the point
  const LightingQuery* lit =
      nullptr;  ///< the point with its viewer, for methods that sample the light
  /// Radiance of the highlight, for a narrow lobe and a light with an extent.
  float highlight = 0.0f;
};

/// The lights that `gather` takes over.
struct HandledLights {
  std::span<const std::uint8_t> taken{};  ///< by light index, 0: not taken; empty: none taken
  bool all = false;                       ///< no light is left for `add`

  [[nodiscard]] bool holds(std::size_t light) const { return !taken.empty() && taken[light] != 0; }
};

/// The part of the scene that is visible in a surface by reflection or refraction. It is blurred by
/// the GGX lobe, or as the mean radiance over a square of directions around the mirrored or
/// refracted one.
struct Reflection {
  const ViewedRay& seen;      ///< the ray that hits the surface
  const SurfacePoint& point;  ///< where it hits the surface
  const Hit& hit;
  glm::vec3 width{0.0f};      ///< width of the square, one unit ahead, by colour; 0: a mirror
  glm::vec3 reflected{0.0f};  ///< radiance towards the viewer per mean radiance
  int layer = 0;              ///< number of surfaces in front of the point
  bool shows_lights = true;   ///< lights that emit evenly are visible, too
  /// Ratio of the indices before and behind a refracting surface; 0: reflection.
  float ratio = 0.0f;
  VolumePath passage = {};     ///< of the ray that leaves
  const Lobe* lobe = nullptr;  ///< lobe that blurs the reflection; null: the square does
  glm::vec3 share{1.0f};       ///< weight of the lobe's radiance in that of the ray

  /// Returns ViewedRay::throughput of the reflected ray.
  [[nodiscard]] float throughput() const {
    return seen.throughput * std::max({reflected.x, reflected.y, reflected.z});
  }
  /// Returns whether the width is the same for all colours.
  [[nodiscard]] bool one_width() const { return width.x == width.y && width.y == width.z; }
};

/// Computes the visibility of lights and the radiance of reflections at a point. Methods differ
/// only in this class; all other shading is the same.
class LightTransport {
 public:
  virtual ~LightTransport() = default;

  /// Takes over some lights of a point, to add their contribution later. `add` is called for the
  /// others that cast shadows, one after the other.
  virtual HandledLights gather(const LightingQuery& /*point*/) { return {}; }

  /// Adds to `radiance` the light's contribution at the point, now or later.
  virtual void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) = 0;

  /// Adds the sky's contribution at the point, now or later. Returns false, without adding
  /// anything, if the sky counts as unoccluded.
  virtual bool add_sky(const SkyQuery& /*point*/, glm::vec3& /*radiance*/,
                       RenderStatistics& /*counts*/) {
    return false;
  }

  /// Adds the reflection's contribution, now or later. Returns false, without adding anything, if
  /// reflections are not followed.
  virtual bool reflect(const Reflection& /*reflection*/, glm::vec3& /*radiance*/,
                       RenderStatistics& /*counts*/) {
    return false;
  }

  /// Called when the shader adds emission or background to the radiance by itself.
  virtual void note(LightPart /*part*/, glm::vec3 /*radiance*/) {}
};

}  // namespace asos
