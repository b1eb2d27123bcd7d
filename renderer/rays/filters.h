#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/world/surface_kind.h"
#include "renderer/world/world.h"

#include <embree3/rtcore.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

// The filters that Embree calls at a hit. Internal to this folder.

namespace asos::tracing {

/// No more light is followed once less than this is left, below what a display can show even at +8
/// stops.
inline constexpr float opaque_enough = 1.0f / (256.0f * 256.0f);

inline constexpr std::size_t most_lanes = 16;

[[nodiscard]] inline float most(glm::vec3 share) {
  return std::max(share.x, std::max(share.y, share.z));
}

/// What surfaces that are not opaque let through.
struct Openness {
  AlphaAt alpha = nullptr;
  PassageAt passage = nullptr;  ///< of blended ones; null: by alpha
};

/// The triangles, or faces of analytic shapes, of one geometry of Embree's; `triangles` maps its
/// primitives to the world's numbers for them (World::is_face) and is empty where the geometry
/// holds all triangles in order.
struct Group {
  const World* world = nullptr;
  Openness open;
  SurfaceKind kind = SurfaceKind::opaque;
  bool owned = false;  ///< its parts are the surfaces of lights
  std::vector<std::uint32_t> triangles;
  float scale = 1.0f;       ///< EmbreeScene::scale
  bool shadowless = false;  ///< lines and points, which no query for shadows meets

  [[nodiscard]] std::uint32_t triangle(unsigned primitive) const {
    return triangles.empty() ? primitive : triangles[primitive];
  }
};

/// The light, by colour, that a packet's rays keep behind surfaces that let light through, by the
/// rays' ids.
struct Lanes {
  /// Some volumes attenuate light: what follows the rest is only of them.
  bool volumes = false;
  std::array<glm::vec3, most_lanes> transmittance;
  std::array<float, most_lanes> touched;  ///< where a masked or blended surface was met first that
                                          ///< is not outlined
  std::array<float, most_lanes> masked;   ///< where a masked one was

  // Of volumes: extinction times way, counted from the rays' starts and added where rays leave,
  // taken off where they enter; and the extinction of those that were entered and not left.
  std::array<glm::vec3, most_lanes> depth;
  std::array<glm::vec3, most_lanes> entered;

  /// The share that is left of a ray that is `way` long and that nothing blocks.
  [[nodiscard]] glm::vec3 left(std::size_t lane, float way) const {
    if (!volumes) return transmittance[lane];
    glm::vec3 all = depth[lane];
    if (std::isfinite(way)) all += way * glm::max(entered[lane], 0.0f);
    return transmittance[lane] * glm::exp(-glm::max(all, 0.0f));
  }

  void reset() {
    if (volumes) {
      depth.fill(glm::vec3(0.0f));
      entered.fill(glm::vec3(0.0f));
    }
    transmittance.fill(glm::vec3(1.0f));
    touched.fill(std::numeric_limits<float>::infinity());
    masked.fill(std::numeric_limits<float>::infinity());
  }
};

/// Embree's geometries by their ids, and the instances, which have the ids behind those.
struct Geometries {
  static constexpr unsigned group_count = 15;

  const Group* groups = nullptr;
  const Placements* placed = nullptr;  ///< null: there are no instances

  /// A hit on the world's surfaces from Embree's numbers. The corners of mirrored instances have
  /// another order in the world.
  [[nodiscard]] Hit hit(unsigned geometry, unsigned primitive, unsigned instance, float t, float u,
                        float v) const {
    if (instance == RTC_INVALID_GEOMETRY_ID) return {groups[geometry].triangle(primitive), t, u, v};
    const Placement& place = placed->places[instance - group_count];
    const std::uint32_t triangle = placed->own_triangles + place.first_triangle + primitive;
    return place.mirrored ? Hit{triangle, t, v, u} : Hit{triangle, t, u, v};
  }
  /// The direction in the world of a ray that Embree hands to a filter: at an instance it is in the
  /// mesh's space.
  [[nodiscard]] glm::vec3 direction(glm::vec3 of_ray, unsigned instance) const {
    if (instance == RTC_INVALID_GEOMETRY_ID) return of_ray;
    const Placement& place = placed->places[instance - group_count];
    return glm::vec3(glm::dmat3(place.world_from_mesh) * glm::dvec3(of_ray));
  }
  /// The hit of ray `i` that a filter has to decide about, with a distance of 0.
  [[nodiscard]] Hit hit(const RTCFilterFunctionNArguments& args, unsigned i) const;
  [[nodiscard]] glm::vec3 direction(const RTCFilterFunctionNArguments& args, unsigned i) const;
};

/// Which parts have a back that a ray for the viewer goes through.
struct Sides {
  const World* world = nullptr;
  std::vector<std::uint8_t> single_sided;  ///< by World's parts
  bool any_single_sided = false;

  /// Whether a ray for the viewer goes through what it hit because it meets its back.
  [[nodiscard]] bool culled(const Hit& hit, glm::vec3 direction) const;
};

/// Embree's context and what the filters need to know of the query.
struct Context {
  RTCIntersectContext base;
  Geometries geometries;
  const Sides* sides;
  std::int32_t ignored_part;
  float scale;  ///< Embree's lengths over the world's: EmbreeScene::scale
  bool of_shadows = false;
  Lanes* lanes = nullptr;  ///< collects what lets light through; closest hits do without
  std::span<const std::uint8_t> outlined = {};  ///< see RayScene::blockers
  std::vector<Hit>* met = nullptr;              ///< collecting_filter's
  bool culls = false;                           ///< it drops the backs of single-sided surfaces

  Context(RTCIntersectContextFlags flags, Geometries all, const Sides* sides_of_parts,
          std::int32_t part_to_ignore, float scale_of_scene)
      : geometries(all),
        sides(sides_of_parts),
        ignored_part(part_to_ignore),
        scale(scale_of_scene) {
    rtcInitIntersectContext(&base);
    base.flags = flags;
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};
static_assert(offsetof(Context, base) == 0, "the filters cast Embree's context back");

/// The filter of a geometry for closest hits: drops an ignored part, what casts no shadow where
/// these are asked for, and holes; with lanes, blended
/// surfaces too, whose attenuation is collected.
void closest_filter(const RTCFilterFunctionNArguments* args);

/// The filter of a geometry for shadow rays: drops an ignored part, holes, and blended surfaces as
/// long as light is left. Needs lanes.
void shadow_filter(const RTCFilterFunctionNArguments* args);

/// The filter of a context, so that only queries that ask for it pay: drops the backs of
/// single-sided surfaces.
void back_filter(const RTCFilterFunctionNArguments* args);

}  // namespace asos::tracing
