#pragma once

#include "renderer/film/statistics.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/viewed_point.h"
#include "renderer/shading/viewed_ray.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <span>

namespace asos {

class Sky;

[[nodiscard]] inline Receiver receiver_at(const SurfacePoint& point) {
  return {glm::dvec3(point.lit_position()), glm::dvec3(point.shading_normal),
          glm::dvec3(point.horizon())};
}

/// The lights that a reflection of a point shows: there the lobe has no highlights of them.
enum class MirroredLights {
  none,       ///< it shows none, or there is no reflection
  patterned,  ///< those whose surface does not shine evenly
  all,        ///< all that have a surface
};

/// A point and all lights that may shine on it, before any of them was looked at.
struct LitPoint {
  std::span<const PreparedLight> lights;  ///< the same for all points of a picture
  const ViewedPoint& view;
  const ViewedMaterial& material;
  MirroredLights mirrored = MirroredLights::none;
  glm::vec3 share{1.0f};  ///< of the point's radiance in that of its ray
  bool shadows = true;    ///< the same for all points of a picture: whether lights cast any
};

/// A point on which the sky may shine.
struct SkyLitPoint {
  const Sky* sky = nullptr;  ///< null: the neutral one
  const ViewedPoint& view;
  const ViewedMaterial& material;
  bool mirrors = false;   ///< its lobe is a reflection
  glm::vec3 share{1.0f};  ///< of the point's radiance in that of its ray
};

/// A light that shines on a point, and what the point makes of it.
struct Illumination {
  const PreparedLight& light;
  std::uint32_t index = 0;  ///< of the light in Lighting::lights
  const SurfacePoint& point;
  glm::vec3 unshadowed{0.0f};     ///< irradiance with nothing in the way
  glm::vec3 reflected{0.0f};      ///< radiance towards the viewer per irradiance
  int layer = 0;                  ///< surfaces that are seen through before the point
  const LitPoint* lit = nullptr;  ///< the point as it is seen, for who samples the light
  float highlight = 0.0f;         ///< radiance of what a narrow lobe shows of a light with a size
};

/// Lights that were gathered.
struct TakenLights {
  std::span<const std::uint8_t> taken{};  ///< one a light, by index, 0: not taken; empty: none is
  bool all = false;                       ///< none is left

  [[nodiscard]] bool holds(std::size_t light) const { return !taken.empty() && taken[light] != 0; }
};

/// The part of the scene that a surface mirrors, or shows through it: what its GGX lobe shows, or
/// the mean radiance over a square of directions around the mirrored or refracted one.
struct Reflection {
  const ViewedRay& seen;      ///< that meets the surface
  const SurfacePoint& point;  ///< where it does so
  const Hit& hit;
  glm::vec3 width{0.0f};      ///< of the square, one unit ahead, by colour; 0: a mirror
  glm::vec3 reflected{0.0f};  ///< radiance towards the viewer per mean radiance
  int layer = 0;              ///< surfaces that are seen through before the point
  bool shows_lights = true;   ///< also those that shine evenly
  float ratio = 0.0f;  ///< of the indices before and behind a surface that refracts; 0: mirrors
  VolumePath passage = {};               ///< of the ray that leaves
  const ViewedMaterial* lobe = nullptr;  ///< whose lobe blurs it; null: the square does, if any
  glm::vec3 share{1.0f};                 ///< of what the lobe shows in the ray's radiance

  /// ViewedRay's, of what is mirrored.
  [[nodiscard]] float throughput() const {
    return seen.throughput * std::max({reflected.x, reflected.y, reflected.z});
  }
  /// The one width of all colours that are reflected, or none.
  [[nodiscard]] bool one_width() const { return width.x == width.y && width.y == width.z; }
};

/// Finds out how much of a light, and what of a reflection, reaches a point: what the methods
/// differ in, while all else about shading is the same for all.
class LightTransport {
 public:
  virtual ~LightTransport() = default;

  /// Takes lights of a point, to add later what the viewer sees of them; `add` gets those others
  /// that cast shadows, one after the other.
  virtual TakenLights gather(const LitPoint& /*point*/) { return {}; }

  /// Adds to `radiance` what the viewer sees of the light by way of the point, now or later.
  virtual void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) = 0;

  /// Adds what reaches the viewer of the sky by way of the point, now or later; false, and nothing
  /// is added, where all of the sky is to be taken for open.
  virtual bool add_sky(const SkyLitPoint& /*point*/, glm::vec3& /*radiance*/,
                       RenderStatistics& /*counts*/) {
    return false;
  }

  /// Adds what the viewer sees of the scene in the surface, now or later; false, and nothing is
  /// added, where reflections are not followed.
  virtual bool reflect(const Reflection& /*reflection*/, glm::vec3& /*radiance*/,
                       RenderStatistics& /*counts*/) {
    return false;
  }
};

}  // namespace asos
