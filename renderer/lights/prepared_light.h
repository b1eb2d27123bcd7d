#pragma once

#include "renderer/lights/polygon_rows.h"
#include "renderer/lights/receiver.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/choices.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace asos {

/// A straight line in a light's own plane where a surface passes through it.
struct LightIntersection {
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
};
/// One list a light: see find_light_intersections.
using LightIntersections = std::vector<std::vector<LightIntersection>>;

/// A light with what its evaluation needs computed once.
struct PreparedLight {
  enum class Shape {
    point,    ///< point and spot
    distant,  ///< directional, a point infinitely far
    ball,     ///< point and spot with a radius
    sun,      ///< directional with an angular diameter
    segment,  ///< linear
    polygon,  ///< rectangle and polygon
    disk,
  };

  Shape shape = Shape::point;
  LightRule rule = LightRule::physical;
  /// Point: candela. Distant: lux. Ball, sun, polygon, disk: nits. Segment: candela a metre.
  glm::vec3 power{0.0f};
  glm::dvec3 position{0.0};     ///< middle: all but distant and sun
  glm::dvec3 towards{0, 0, 1};  ///< unit: distant, sun: to the light; spot: against its axis;
                                ///< polygon, disk: the way it shines, its normal
  double radius = 0.0;          ///< ball, disk; sun: tangent of half its angular diameter
  glm::dvec3 half_u{0.0};       ///< segment: from the middle to an end. Polygon, disk: the edges of
  glm::dvec3 half_v{0.0};  ///< a rectangle around it, halved; half_u x half_v lies along towards
  std::vector<std::vector<glm::dvec3>> outlines;  ///< polygon: see Light::outlines
  double area = 0.0;                              ///< polygon, disk: of one side
  PolygonRows rows;        ///< polygon but a rectangle: in units of length along half_u, half_v
  bool rectangle = false;  ///< polygon: the outline is the rectangle position +- half_u +- half_v
  /// Polygon, disk: how far from its plane its own surface may lie, by rounding and by what is
  /// taken for flat where a mesh shines. What is no farther lies in it, and gets nothing of it.
  double thickness = 0.0;
  bool two_sided = false;
  bool casts_shadows = true;
  double inverse_range = 0.0;
  double cone_scale = 0.0;  ///< spot: (scale * cos + offset)^2, clamped to 0..1
  double cone_offset = 1.0;
  std::int32_t own_part = -1;
  bool patterned = false;  ///< its own part does not shine evenly: it is the mean
  std::vector<LightIntersection>
      intersections;     ///< polygon, disk: where surfaces of the world pass through it
  bool entered = false;  ///< ball: a surface of the world that is not its own reaches into it

  /// Whether it has a size, so that its shadows have penumbrae.
  [[nodiscard]] bool extended() const { return shape != Shape::point && shape != Shape::distant; }
  /// Whether what is so high above a flat light's plane, or below it, sees a side that shines.
  [[nodiscard]] bool faces(double height) const {
    return height > thickness || (two_sided && height < -thickness);
  }
};

/// A light of no size (a ball of radius 0, a disk, polygon or segment without extent) gives a point
/// or nothing, never anything that is not finite.
[[nodiscard]] PreparedLight prepare_light(const Light& light, LightRule rule = LightRule::physical);

/// The share that a spot's cone and a range leave of the light that goes to a point, 0 to 1: those
/// of the light's middle stand for all of it.
[[nodiscard]] double attenuation(const PreparedLight& light, glm::dvec3 position);

/// The irradiance that a receiver gets of the whole light with nothing in the way, clipped to both
/// its horizons: 0 below. Finite for all finite input; a receiver at the very place of a point
/// light gets nothing.
[[nodiscard]] glm::vec3 unshadowed_irradiance(const PreparedLight& light, const Receiver& receiver);

/// The same for the part of a segment between the parameters t0 < t1 in -1..1 along half_u.
[[nodiscard]] glm::vec3 segment_irradiance(const PreparedLight& light, const Receiver& receiver,
                                           double t0, double t1);

/// One point of a light, for a shadow ray.
struct LightSample {
  glm::dvec3 direction{0, 1, 0};  ///< unit, from the receiver
  double distance = 0.0;          ///< to the point; infinite for distant lights and suns
  glm::vec3 irradiance{0.0f};     ///< given by the light by this sample's measure if it is seen
};

/// Chooses a point by two numbers in 0..1 so that the mean of `irradiance` over the unit square is
/// unshadowed_irradiance. Rectangles by solid angle (Urena, Fajardo and King 2013; by area where
/// they look small), balls and suns by solid angle (Shirley, Wang and Zimmerman 1996), segments by
/// the angle at the receiver (Kulla and Fajardo 2012), disks and other polygons by area.
/// Stratification of (u, v) carries over. By the published rule the samples are the physical ones,
/// and so is their mean, but for segments, whose points then shine the same in all directions.
[[nodiscard]] LightSample sample_light(const PreparedLight& light, const Receiver& receiver,
                                       double u, double v);

/// The direction to, and the tangent of the half angle of, what stands for the whole of a light in
/// a highlight: the light's point nearest to the mirrored view (Karis 2013, "Representative point
/// method"; of a polygon the nearest of the rectangle around it). The direction is unit. The
/// tangent is the light's radius over the distance: a ball's own to its middle; that of the disk of
/// the same area, or half the length, to the point. At most 1 but for suns; 0 without size.
struct Highlight {
  glm::vec3 direction{0, 1, 0};
  float half_angle_tangent = 0.0f;
  /// To the point, or a ball's surface; 0 within one.
  float distance = std::numeric_limits<float>::infinity();
};
/// `mirrored_view` is unit and leads away from the surface.
[[nodiscard]] Highlight highlight_of(const PreparedLight& light, glm::dvec3 position,
                                     glm::dvec3 mirrored_view);

}  // namespace asos
