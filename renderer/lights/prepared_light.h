#pragma once

#include "renderer/lights/light_shape.h"
#include "renderer/lights/polygon_rows.h"
#include "renderer/lights/receiver.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/choices.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace asos {

/// A straight line in a light's own plane where a surface passes through it.
struct LightIntersection {
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
};
/// One list per light: see find_light_intersections.
using LightIntersections = std::vector<std::vector<LightIntersection>>;

/// A light with precomputed data for its evaluation.
struct PreparedLight {
  LightShape shape = LightShape::point;
  LightRule rule = LightRule::physical;
  /// Point: candela. Distant: lux. Segment: candela per metre. Others: nits.
  glm::vec3 power{0.0f};
  glm::dvec3 position{0.0};     ///< centre: all but distant and sun
  glm::dvec3 towards{0, 0, 1};  ///< unit: distant, sun: to the light; spot: against its axis;
                                ///< flat: the normal of its emitting side
  double radius = 0.0;          ///< ball, capsule, disk; sun: tangent of half its angular diameter
  /// Segment, capsule: from the centre to an end of the axis. Flat: the edges of the bounding
  /// rectangle, halved; half_u x half_v lies along towards.
  glm::dvec3 half_u{0.0};
  glm::dvec3 half_v{0.0};
  glm::dvec3 u_axis{0.0}, v_axis{0.0};  ///< unit vectors along half_u and half_v, or 0
  double u_length = 0.0, v_length = 0.0;
  std::vector<std::vector<glm::dvec3>> outlines;  ///< rectangle, polygon: see Light::outlines
  double one_less_cosine = 0.0;                   ///< sun: 1 - the cosine of its half angle
  double highlight_radius = 0.0;  ///< line, flat, capsule: of the representative point
  double area = 0.0;  ///< flat: of one side; capsule: projected, from a direction across its axis
  PolygonRows rows;   ///< polygon: in metres along half_u, half_v
  /// Flat: largest distance of its own surface from its plane, by rounding and by the
  /// tolerance for flat meshes. A point within it lies in the light and receives nothing from it.
  double thickness = 0.0;
  bool two_sided = false;
  bool casts_shadows = true;
  double inverse_range = 0.0;
  double cone_scale = 0.0;  ///< spot: (scale * cos + offset)^2, clamped to 0..1
  double cone_offset = 1.0;
  std::int32_t own_part = -1;
  bool patterned = false;  ///< its own part emits unevenly; the light is the mean
  std::vector<LightIntersection>
      intersections;     ///< flat: where surfaces of the world pass through it
  bool entered = false;  ///< ball, capsule: another part's surface reaches into it

  [[nodiscard]] const LightTraits& traits() const { return traits_of(shape); }
  /// Returns whether the light has an extent, so that its shadows have penumbrae.
  [[nodiscard]] bool extended() const { return traits().extended; }
  /// Returns whether a point at this height above a flat light's plane (negative: below) is on an
  /// emitting side.
  [[nodiscard]] bool faces(double height) const {
    return height > thickness || (two_sided && height < -thickness);
  }
};

/// Returns the shape of a light whose sizes are usable: prepare_light may return a simpler one.
[[nodiscard]] LightShape light_shape(const Light& light);

/// Prepares a light. A light without extent (a ball of radius 0, a disk, polygon or segment without
/// size) becomes a point or nothing, and never has a value that is not finite.
[[nodiscard]] PreparedLight prepare_light(const Light& light, LightRule rule = LightRule::physical);

/// Returns the fraction of light towards a point after a spot's cone and range, 0 to 1. It is taken
/// at the light's centre.
[[nodiscard]] double attenuation(const PreparedLight& light, glm::dvec3 position);

/// Returns the unshadowed irradiance of a receiver from the whole light, clipped to both its
/// horizons: 0 below. Finite for all finite input; 0 for a receiver at the position of a point
/// light.
[[nodiscard]] glm::vec3 unshadowed_irradiance(const PreparedLight& light, const Receiver& receiver);

/// Returns unshadowed_irradiance for the part of a segment between the parameters t0 < t1 in -1..1
/// along half_u.
[[nodiscard]] glm::vec3 segment_irradiance(const PreparedLight& light, const Receiver& receiver,
                                           double t0, double t1);

/// One point of a light, for a shadow ray.
struct LightSample {
  glm::dvec3 direction{0, 1, 0};  ///< unit, from the receiver
  double distance = 0.0;          ///< to the point; infinite for distant lights and suns
  glm::vec3 irradiance{0.0f};     ///< estimate of the whole light's irradiance, if visible
};

/// Samples a point of a light from two numbers in 0..1. The mean of `irradiance` over the unit
/// square is unshadowed_irradiance. Rectangles are sampled by solid angle (Urena, Fajardo and King
/// 2013; by area if their solid angle is small), balls and suns by solid angle (Shirley, Wang and
/// Zimmerman 1996), and capsules by solid angle, too. Segments are sampled by the angle at the
/// receiver (Kulla and Fajardo 2012), disks and other polygons by area. Stratification of (u, v) is
/// preserved. By the published rule, samples and mean are the physical ones, except that points of
/// a segment emit equally in all directions.
[[nodiscard]] LightSample sample_light(const PreparedLight& light, const Receiver& receiver,
                                       double u, double v);

/// Returns the numbers of a sample for the kernels, of a shape with
/// Sampling::lanes_or_scalar.
[[nodiscard]] glm::vec4 sample_numbers(const PreparedLight& light, const Receiver& receiver,
                                       double u, double v);

/// Where a direction from a receiver hits a light or, from inside, leaves it; and the density of
/// the light's samples there, by solid angle.
struct SampledHit {
  double distance = 0.0, density = 0.0;
};
/// Returns the hit of a direction with a light that has no other function for it in the kernels.
[[nodiscard]] std::optional<SampledHit> sampled_hit(const PreparedLight& light,
                                                    const Receiver& receiver, glm::dvec3 direction);

/// The representative point of a light for its highlight: the light's point nearest to the mirrored
/// view (Karis 2013, "Representative point method"; for a polygon the nearest point of its bounding
/// rectangle). The direction is unit. The tangent of the half angle is the light's radius over the
/// distance. For a ball these are its own radius and the distance of its centre. For others it is
/// the radius of the disk with the same area, or half the length, and the distance of the point. At
/// most 1 except for suns; 0 without an extent.
struct Highlight {
  glm::vec3 direction{0, 1, 0};
  float half_angle_tangent = 0.0f;
  /// Distance to the point or the ball's surface; 0 inside a ball.
  float distance = std::numeric_limits<float>::infinity();
};
/// `mirrored_view` is unit and leads away from the surface.
[[nodiscard]] Highlight highlight_of(const PreparedLight& light, glm::dvec3 position,
                                     glm::dvec3 mirrored_view);

}  // namespace asos
