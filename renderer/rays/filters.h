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

/// A ray counts as blocked once its remaining light is below this fraction, which is invisible even
/// at +8 stops.
inline constexpr float opaque_enough = 1.0f / (256.0f * 256.0f);

inline constexpr std::size_t most_lanes = 16;

[[nodiscard]] inline float most(glm::vec3 share) {
  return std::max(share.x, std::max(share.y, share.z));
}

/// The transparency of surfaces that are not opaque.
struct Transparency {
  AlphaAt alpha = nullptr;
  TransmissionAt passage = nullptr;  ///< for blended surfaces; null: by alpha

  bool operator==(const Transparency&) const = default;
};

/// The world's numbers of a geometry's primitives.
struct Numbers {
  const std::uint32_t* list = nullptr;  ///< by primitive; Hit::none: hidden. Null: consecutive
  std::uint32_t first = 0;

  [[nodiscard]] std::uint32_t of(unsigned primitive) const {
    return list ? list[primitive] : first + primitive;
  }
};

/// The triangles, or faces of analytic shapes, of one of Embree's geometries, as numbered in the
/// world that it was built from. It may be used by other worlds, which number them otherwise.
struct Group {
  Transparency open;
  SurfaceKind kind = SurfaceKind::opaque;
  bool owned = false;               ///< holds the surfaces of lights
  bool shadowless = false;          ///< lines and points, which shadow queries ignore
  float scale = 1.0f;               ///< EmbreeScene::scale
  std::vector<std::uint32_t> list;  ///< empty: consecutive numbers
  std::uint32_t first = 0, count = 0;
  /// The faces of one world, or of each pose of a motion at even times.
  std::span<const std::vector<ShapeFace>> faces;
  std::uint32_t first_face = 0;  ///< number of the first face in the world

  [[nodiscard]] Numbers numbers() const { return {list.empty() ? nullptr : list.data(), first}; }
  [[nodiscard]] std::size_t face_of(unsigned primitive) const {
    return numbers().of(primitive) - first_face;
  }
};

/// The remaining light, by colour, of a packet's rays behind transparent surfaces, by the rays'
/// ids.
struct Lanes {
  /// Whether volumes attenuate light; the members after `masked` are for volumes only.
  bool volumes = false;
  std::array<glm::vec3, most_lanes> transmittance;
  std::array<float, most_lanes> touched;  ///< distance of the first masked or blended surface that
                                          ///< is not outlined
  std::array<float, most_lanes> masked;   ///< distance of the first masked one of these

  // For volumes: extinction times distance, measured from the rays' starts, added where rays leave
  // and subtracted where they enter; and the extinction of volumes that were entered but not left.
  std::array<glm::vec3, most_lanes> depth;
  std::array<glm::vec3, most_lanes> entered;

  /// Returns the remaining fraction of a ray of length `way` that nothing blocks.
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

/// Embree's geometries by id, followed by the instances. Groups of surfaces that stand still come
/// before the same groups of those that move.
struct Geometries {
  static constexpr unsigned still_count = 16;
  static constexpr unsigned group_count = 2 * still_count;

  const Numbers* numbers = nullptr;    ///< by geometry
  const Placements* placed = nullptr;  ///< null: there are no instances

  /// Returns the hit on the world's surfaces for Embree's numbers. The corners of mirrored
  /// instances have another order in the world.
  [[nodiscard]] Hit hit(unsigned geometry, unsigned primitive, unsigned instance, float t, float u,
                        float v) const {
    if (instance == RTC_INVALID_GEOMETRY_ID) return {numbers[geometry].of(primitive), t, u, v};
    const Placement& place = placed->places[instance - group_count];
    const std::uint32_t triangle = placed->own_triangles + place.first_triangle + primitive;
    return place.mirrored ? Hit{triangle, t, v, u} : Hit{triangle, t, u, v};
  }
  /// Returns the direction in the world of a ray in a filter: at an instance it is in the mesh's
  /// space.
  [[nodiscard]] glm::vec3 direction(glm::vec3 of_ray, unsigned instance) const {
    if (instance == RTC_INVALID_GEOMETRY_ID) return of_ray;
    const Placement& place = placed->places[instance - group_count];
    return glm::vec3(glm::dmat3(place.world_from_mesh) * glm::dvec3(of_ray));
  }
  /// Returns the candidate hit of ray `i` in a filter, with a distance of 0.
  [[nodiscard]] Hit hit(const RTCFilterFunctionNArguments& args, unsigned i) const;
  [[nodiscard]] glm::vec3 direction(const RTCFilterFunctionNArguments& args, unsigned i) const;
};

/// Which parts have a back that rays for the viewer pass through.
struct Sides {
  const World* world = nullptr;
  std::span<const std::uint8_t> single_sided;  ///< by World's parts
  bool any_single_sided = false;

  /// Returns whether a ray for the viewer passes through a hit because it is on the back.
  [[nodiscard]] bool culled(const Hit& hit, glm::vec3 direction) const;
};

/// The filter of a context, so that only queries with it are slower: drops hidden surfaces.
void hiding_filter(const RTCFilterFunctionNArguments* args);

/// Embree's context with the filters' data for the query.
struct Context {
  RTCIntersectContext base;
  Geometries geometries;
  Sides sides;
  std::int32_t ignored_part;
  float scale;  ///< ratio of Embree's lengths to the world's: EmbreeScene::scale
  bool of_shadows = false;
  Lanes* lanes = nullptr;                       ///< collects transmittances; null for closest hits
  std::span<const std::uint8_t> outlined = {};  ///< see RayScene::blockers
  std::vector<Hit>* met = nullptr;              ///< for collecting_filter
  bool culls = false;                           ///< drops the backs of single-sided surfaces
  std::span<const float> times;                 ///< of the rays, 0 to 1; empty: all 0

  Context(RTCIntersectContextFlags flags, Geometries all, const Sides& sides_of_parts,
          std::int32_t part_to_ignore, float scale_of_scene, std::span<const float> times_of_rays,
          bool hides)
      : geometries(all),
        sides(sides_of_parts),
        ignored_part(part_to_ignore),
        scale(scale_of_scene),
        times(times_of_rays) {
    rtcInitIntersectContext(&base);
    base.flags = flags;
    if (hides) base.filter = hiding_filter;
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] const World& world() const { return *sides.world; }
  [[nodiscard]] float time_of(std::size_t ray) const { return times.empty() ? 0.0f : times[ray]; }
};
static_assert(offsetof(Context, base) == 0, "the filters cast Embree's context back");

/// The filter of a geometry for closest hits. Drops an ignored part, holes, and, for shadow
/// queries, surfaces that cast no shadow. With lanes, also drops blended surfaces and collects
/// their attenuation.
void closest_filter(const RTCFilterFunctionNArguments* args);

/// The filter of a geometry for shadow rays: drops an ignored part, holes, and blended surfaces
/// while light remains. Needs lanes.
void shadow_filter(const RTCFilterFunctionNArguments* args);

/// The filter of a context: drops hidden surfaces, and the backs of single-sided ones.
void back_filter(const RTCFilterFunctionNArguments* args);

}  // namespace asos::tracing
