#include "ui/edited_light.h"

#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace asos::ui {

namespace {

using std::numbers::pi;

/// Orthonormal frame of a light: the direction it faces, with the directions to its right and up.
struct Basis {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};
};

// Built from the angles alone, so it is defined at the poles, too.
Basis basis_of(const LightTurn& t) {
  const double sa = std::sin(t.azimuth_rad), ca = std::cos(t.azimuth_rad);
  const double se = std::sin(t.elevation_rad), ce = std::cos(t.elevation_rad);
  const double sr = std::sin(t.roll_rad), cr = std::cos(t.roll_rad);
  const glm::dvec3 right(ca, 0.0, -sa), up(-sa * se, ce, -ca * se);
  return {cr * right + sr * up, cr * up - sr * right, {sa * ce, se, ca * ce}};
}

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 fallback) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

glm::dvec3 forward_of(const Light& light) {
  return row_of(light).line() ? unit_or(light.half_u, {1, 0, 0})
                              : unit_or(light.direction, {0, 0, -1});
}

/// The side that defines the light's roll; zero for lights that are symmetric about their axis.
glm::dvec3 side_of(const Light& light) {
  if (!light.outlines.empty() && !light.outlines.front().empty())
    return light.outlines.front().front() - light.position;
  return row_of(light).rolls() ? light.half_u : glm::dvec3(0.0);
}

/// Returns the orientation towards `forward`, with the roll of `side`; zero: none.
LightTurn turn_towards(glm::dvec3 forward, glm::dvec3 side) {
  const double horizontal = std::hypot(forward.x, forward.z);
  LightTurn turn;
  turn.elevation_rad = std::atan2(forward.y, horizontal);
  if (horizontal > 1e-9) {
    turn.azimuth_rad = std::atan2(forward.x, forward.z);
  } else if (side != glm::dvec3(0.0)) {
    turn.azimuth_rad = std::atan2(-side.z, side.x);
  }
  const Basis level = basis_of(turn);
  if (side != glm::dvec3(0.0))
    turn.roll_rad = std::atan2(glm::dot(side, level.up), glm::dot(side, level.right));
  return turn;
}

double outline_area(const std::vector<glm::dvec3>& outline, glm::dvec3 direction) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return 0.5 * glm::dot(sum, direction);
}

/// Candela per unit of the light's intensity, on its axis and from far away.
double candela_per_unit(const Light& light, double distance) {
  if (!has_position(light)) return distance * distance;
  return is_flat(light) ? area_of(light) : 1.0;
}

/// Half of the light's extent; 0 for a light without a size.
double half_size(const Light& light, double distance) {
  const LightKindRow& row = row_of(light);
  if (row.has_outlines()) return polygon_radius(light);
  if (row.size.half) {
    const double half = glm::length(light.*row.size.half);
    return row.line() ? half : std::sqrt(half * glm::length(light.*row.second.half));
  }
  if (!row.size.value) return 0.0;
  const double value = light.*row.size.value;
  return row.size.is_angle() ? distance * std::tan(0.5 * value) : value;
}

/// Corners in counter-clockwise order, starting at the right: the first corner defines a light's
/// roll. Every other corner has the radius `inner`.
std::vector<glm::dvec2> ring(int corners, double radius, double inner) {
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * pi * i / corners;
    const double r = i % 2 == 0 ? radius : inner;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return outline;
}

std::vector<std::vector<glm::dvec2>> outlines_of(PolygonShape shape) {
  std::vector<glm::dvec2> hole = ring(4, 0.6, 0.6);
  switch (shape) {
    case PolygonShape::hexagon:
      return {ring(6, 1.0, 1.0)};
    case PolygonShape::star:
      return {ring(10, 1.0, 0.4)};
    case PolygonShape::frame:
      std::reverse(hole.begin(), hole.end());
      return {ring(4, 1.0, 1.0), hole};
    case PolygonShape::triangle:
      break;
  }
  return {ring(3, 1.0, 1.0)};
}

void lay_outlines(Light& light, const Basis& basis, PolygonShape shape, double radius) {
  light.outlines.clear();
  for (const auto& flat : outlines_of(shape)) {
    auto& outline = light.outlines.emplace_back();
    for (const glm::dvec2 p : flat)
      outline.push_back(light.position + radius * (p.x * basis.right + p.y * basis.up));
  }
}

/// `half`: half of the light's width. `distance`: from the light to the surface that it lights.
void give_shape(Light& light, const LightKindRow& row, const Basis& basis, double half,
                double distance) {
  light.radius = 0.0;
  light.angular_diameter_rad = 0.0;
  light.half_u = light.half_v = glm::dvec3(0.0);
  light.outlines.clear();
  if (row.has_outlines()) lay_outlines(light, basis, PolygonShape::hexagon, half);
  if (row.size.value)
    light.*row.size.value = row.size.is_angle() ? 2.0 * std::atan(half / distance) : half;
  if (row.size.half) light.*row.size.half = half * basis.right;
  if (row.second.half) light.*row.second.half = half * basis.up;
}

/// Returns the unshadowed irradiance of the light, made white, at `place` on a surface that faces
/// its centre. Returns 0 if it is not finite.
double arriving(const Light& light, glm::dvec3 place) {
  const glm::dvec3 way = has_position(light) ? light.position - place : -light.direction;
  const glm::dvec3 normal = unit_or(way, {0, 1, 0});
  Light white = light;
  white.color = glm::vec3(1.0f);
  const double e =
      static_cast<double>(unshadowed_irradiance(prepare_light(white), {place, normal, normal}).x);
  return std::isfinite(e) ? e : 0.0;
}

}  // namespace

SceneSize SceneSize::of(const Box& bounds) {
  if (bounds.empty()) return {};
  const glm::dvec3 lo(bounds.lo), hi(bounds.hi);
  const double radius = 0.5 * glm::length(hi - lo);
  return {0.5 * (lo + hi), radius > 0.0 ? radius : 1.0};
}

bool is_flat(const Light& light) {
  return traits_of(light_shape(light)).flat;
}

bool has_position(const Light& light) {
  return !traits_of(light_shape(light)).infinite;
}

bool has_direction(const Light& light) {
  return is_flat(light) || row_of(light).has_cone() || !has_position(light);
}

double area_of(const Light& light) {
  if (light.outlines.empty()) return is_flat(light) ? prepare_light(light).area : 0.0;
  double area = 0.0;
  for (const auto& outline : light.outlines) area += outline_area(outline, light.direction);
  return std::abs(area);
}

Light as_kind(const Light& light, LightKind kind, const SceneSize& scene, bool has_place) {
  if (kind_of(light) == kind) return light;
  Light other = light;
  constexpr double away = 1.5;  // of a light at infinity, in radii of the scene
  if (!has_position(light) && !has_place)
    other.position = scene.middle - away * scene.radius * forward_of(light);
  if (!has_direction(light)) other.direction = unit_or(scene.middle - other.position, {0, -1, 0});
  const double distance = std::max(glm::distance(other.position, scene.middle), 0.1 * scene.radius);

  // A light that has a size keeps it.
  double half = half_size(light, distance);
  if (!(half > 0.0)) half = usual_half_size * distance;
  other.type = row_of(kind).type;
  const glm::dvec3 side = light.outlines.empty() ? side_of(light) : glm::dvec3(0.0);
  const LightTurn turn = turn_towards(unit_or(other.direction, {0, 0, -1}), side);
  give_shape(other, row_of(kind), basis_of(turn), half, distance);
  const double candela = static_cast<double>(light.intensity) * candela_per_unit(light, distance);
  other.intensity = static_cast<float>(candela / candela_per_unit(other, distance));
  // The candela match far from the light. Scale by the irradiance in the scene's centre, where the
  // two lights differ because of their extent or direction.
  const double before = arriving(light, scene.middle), after = arriving(other, scene.middle);
  const double factor = after > 0.0 ? before / after : 1.0;
  constexpr double most_factor = 16.0;  // more: the light does not face the centre
  if (factor > 1.0 / most_factor && factor < most_factor)
    other.intensity = static_cast<float>(factor * static_cast<double>(other.intensity));
  return other;
}

LightTurn turn_of(const Light& light) {
  return turn_towards(forward_of(light), side_of(light));
}

void turn_light(Light& light, const LightTurn& turn) {
  const Basis from = basis_of(turn_of(light)), to = basis_of(turn);
  const glm::dmat3 rotation = glm::dmat3(to.right, to.up, to.forward) *
                              glm::transpose(glm::dmat3(from.right, from.up, from.forward));
  const LightKindRow& row = row_of(light);
  if (row.line()) {
    light.half_u = glm::length(light.half_u) * to.forward;
    return;
  }
  light.direction = to.forward;
  // Rebuild the sides from their lengths: repeated rotation would lose their right angle.
  if (row.second.half) {
    light.half_u = glm::length(light.half_u) * to.right;
    light.half_v = glm::length(light.half_v) * to.up;
  }
  for (auto& outline : light.outlines) {
    for (glm::dvec3& p : outline) p = light.position + rotation * (p - light.position);
  }
}

void move_light(Light& light, glm::dvec3 by) {
  light.position += by;
  for (auto& outline : light.outlines) {
    for (glm::dvec3& p : outline) p += by;
  }
}

void carry_around(Light& light, glm::dvec3 about, double by_rad) {
  const double s = std::sin(by_rad), c = std::cos(by_rad);
  const glm::dvec3 from = light.position - about;
  const glm::dvec3 to(c * from.x + s * from.z, from.y, c * from.z - s * from.x);
  move_light(light, to - from);
  LightTurn turn = turn_of(light);
  turn.azimuth_rad += by_rad;
  turn_light(light, turn);
}

double polygon_radius(const Light& light) {
  double radius = 0.0;
  for (const auto& outline : light.outlines) {
    for (const glm::dvec3& p : outline) radius = std::max(radius, glm::distance(p, light.position));
  }
  return radius;
}

void set_polygon_radius(Light& light, double radius) {
  const double old = polygon_radius(light);
  if (!(old > 0.0) || !(radius > 0.0)) return;
  for (auto& outline : light.outlines) {
    for (glm::dvec3& p : outline) p = light.position + (radius / old) * (p - light.position);
  }
}

void set_polygon_shape(Light& light, PolygonShape shape) {
  const double radius = polygon_radius(light);
  lay_outlines(light, basis_of(turn_of(light)), shape, radius);
}

std::optional<PolygonShape> polygon_shape(const Light& light) {
  const double radius = polygon_radius(light);
  const auto same = [&](const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](glm::dvec3 p, glm::dvec3 q) {
      return glm::distance(p, q) <= 1e-6 * radius;
    });
  };
  for (std::size_t i = 0; i < polygon_shape_count; ++i) {
    Light regular = light;
    set_polygon_shape(regular, static_cast<PolygonShape>(i));
    if (std::equal(light.outlines.begin(), light.outlines.end(), regular.outlines.begin(),
                   regular.outlines.end(), same))
      return static_cast<PolygonShape>(i);
  }
  return std::nullopt;
}

void keep_power(Light& light, double area_before) {
  const double area = area_of(light);
  if (area > 0.0 && area_before > 0.0)
    light.intensity = static_cast<float>(static_cast<double>(light.intensity) * area_before / area);
}

void tidy_light(Light& light) {
  const float brightest = std::max({light.color.x, light.color.y, light.color.z});
  if (brightest > 1.0f) {
    light.color /= brightest;
    light.intensity *= brightest;
  }
  if (light.outlines.empty() || light.outlines.front().empty()) return;
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : light.outlines.front()) sum += p;
  light.position = sum / static_cast<double>(light.outlines.front().size());
}

EditedLight EditedLight::of(Light light) {
  const float brightest = std::max({light.color.x, light.color.y, light.color.z});
  const bool on = light.intensity > 0.0f || brightest <= 0.0f;
  if (!on) light.intensity = 1.0f;
  tidy_light(light);
  return {light, on, light};
}

std::vector<Light> lights_on(const std::vector<EditedLight>& lights) {
  std::vector<Light> on;
  for (const EditedLight& edited : lights) {
    if (edited.on) on.push_back(edited.light);
  }
  return on;
}

Light stored_light(const EditedLight& edited) {
  Light light = edited.light;
  if (!edited.on) light.color *= std::exchange(light.intensity, 0.0f);
  return light;
}

}  // namespace asos::ui
