#pragma once

#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/reflector_material.h"
#include "tests/support/render_picture.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/sample_lights.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_scene.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

// A sphere, a plane and a box under one light by the rendering equation, pixel by pixel.

namespace asos::test::true_light {

inline constexpr int width = 80, height = 60;
/// The reference is computed for every fifth pixel in both directions.
inline constexpr int stride = 5;

enum class Subject { sphere, plane, box };

inline constexpr double sphere_radius = 0.45;
inline constexpr double box_half = 0.3;

inline Camera camera_for(Subject subject) {
  if (subject == Subject::sphere) return look_at({0.3, 0.5, 2.2}, {0, 0, 0}, 0.5);
  if (subject == Subject::plane) return look_at({0.3, 0.9, 2.0}, {0, 0, 0}, 0.5);
  return look_at({1.0, 1.1, 1.6}, {0, 0, 0}, 0.5);
}

/// The light above the origin, moved slightly away from the camera.
inline Light placed(Light light) {
  light.position = {0.1, 1.3, -0.3};
  light.direction = glm::normalize(glm::dvec3(0.0, -1.0, 0.15));
  light.color = glm::vec3(1.0f);
  light.intensity = 3.0f;
  return light;
}

inline Light light_of(const std::string& kind) {
  const glm::dvec3 u(1, 0, 0);
  const glm::dvec3 down = glm::normalize(glm::dvec3(0.0, -1.0, 0.15));
  const glm::dvec3 v = glm::cross(down, u);
  Light light;
  if (kind == "rectangle") {
    light = placed(rectangle_light());
    light.half_u = 0.6 * u;
    light.half_v = 0.3 * v;
  } else if (kind == "disk") {
    light = placed(disk_light());
    light.radius = 0.4;
  } else if (kind == "ball") {
    light = placed(ball_light(0.3));
  } else if (kind == "line") {
    light = placed(linear_light());
    light.half_u = 0.6 * u;
  } else if (kind == "capsule") {
    light = placed(capsule_light(0.15));
    light.half_u = 0.6 * u;
  } else if (kind == "sun") {
    light = placed(sun_light(0.3));
    light.direction = glm::normalize(glm::dvec3(-0.1, -1.0, 0.3));
  } else {
    light = placed(polygon_light());
    const auto outline = [&](double x, double y) {
      const glm::dvec3 p = light.position;
      return std::vector<glm::dvec3>{p - x * u - y * v, p + x * u - y * v, p + x * u + y * v,
                                     p - x * u + y * v};
    };
    light.outlines = {outline(0.6, 0.4), outline(0.3, 0.15)};
  }
  return light;
}

inline World world_of(Subject subject, const Reflector& reflector) {
  World world;
  const Material material = material_of(reflector);
  if (subject == Subject::sphere) {
    add_shape(world, sphere(sphere_radius), glm::dmat4(1.0), material);
  } else if (subject == Subject::plane) {
    add_quad(world, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, material);
  } else {
    constexpr auto h = static_cast<float>(box_half);
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        glm::vec3 out(0.0f), u(0.0f), v(0.0f);
        out[axis] = side * h;
        u[(axis + 1) % 3] = 2.0f * h;
        v[(axis + 2) % 3] = 2.0f * h * side;
        add_quad(world, out - 0.5f * u - 0.5f * v, u, v, material);
      }
    }
  }
  return world;
}

/// The point where a ray hits the subject, and its face, computed exactly.
struct Met {
  SeenPoint point;
  int face = 0;
};
inline std::optional<Met> meet(Subject subject, glm::dvec3 origin, glm::dvec3 direction) {
  const auto met = [&](double t, glm::dvec3 normal, int face) {
    return Met{{origin + t * direction, normal, -direction}, face};
  };
  if (subject == Subject::plane) {
    if (!(direction.y < 0.0)) return std::nullopt;
    return met(-origin.y / direction.y, {0, 1, 0}, 0);
  }
  if (subject == Subject::sphere) {
    const double along = -glm::dot(origin, direction);
    const glm::dvec3 beside = origin + along * direction;
    const double depth2 = sphere_radius * sphere_radius - glm::dot(beside, beside);
    if (!(depth2 > 0.0)) return std::nullopt;
    const double t = along - std::sqrt(depth2);
    return met(t, (origin + t * direction) / sphere_radius, 0);
  }
  double enter = 0.0, leave = 1e9;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = direction[axis] > 0.0 ? -1.0 : 1.0;
    const double near = (side * box_half - origin[axis]) / direction[axis];
    if (near > enter) enter = near, face = axis;
    leave = std::min(leave, (-side * box_half - origin[axis]) / direction[axis]);
  }
  if (!(enter < leave)) return std::nullopt;
  glm::dvec3 normal(0.0);
  normal[face] = direction[face] > 0.0 ? -1.0 : 1.0;
  return met(enter, normal, face);
}

/// Node i of n (even), in 0..1: two-point Gauss-Legendre rule per interval.
inline double node(int i, int n) {
  const double offset = (i % 2 == 0 ? -1.0 : 1.0) / std::numbers::sqrt3;
  return (2.0 * (i / 2) + 1.0 + offset) / n;
}

/// The reference from n x n points of each pixel that shows a single face of the subject; no value
/// elsewhere.
inline std::vector<std::optional<glm::dvec3>> truth(Subject subject, const Reflector& reflector,
                                                    const PreparedLight& light, int n) {
  const View view(camera_for(subject), width, height);
  const auto at = [&](double x, double y) {
    const Ray ray = view.ray(x, y);
    return meet(subject, glm::dvec3(ray.origin), glm::normalize(glm::dvec3(ray.direction)));
  };
  std::vector<std::optional<glm::dvec3>> picture;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      auto& pixel = picture.emplace_back();
      if (x % stride != 2 || y % stride != 2) continue;
      bool whole = true;
      const auto first = at(x, y);
      for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const auto met = at(x + corner.x, y + corner.y);
        whole = whole && met && met->face == first->face;
      }
      if (!whole) continue;
      glm::dvec3 sum(0.0);
      for (int i = 0; i < n * n; ++i) {
        const auto met = at(x + node(i % n, n), y + node(i / n, n));
        sum += reflected_radiance(light, reflector, met->point);
      }
      pixel = sum / static_cast<double>(n * n);
    }
  }
  return picture;
}

inline RenderSettings settings_for(Method method) {
  RenderSettings settings = make_settings(width, height, method);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  settings.asos.max_level = 3;
  return settings;
}

struct Errors {
  double mean = 0.0;  ///< of the truth
  double bias = 0.0;  ///< over the mean
  double rmse = 0.0;
  double worst = 0.0;
};

inline Errors errors_of(const Film& film, const std::vector<std::optional<glm::dvec3>>& exact) {
  Errors e;
  double square = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!exact[i]) continue;
    for (int c = 0; c < 3; ++c) {
      // Values above white are displayed as white.
      const double truth = std::min(1.0, (*exact[i])[c]);
      const double off = std::min(1.0, static_cast<double>(film.radiance[i][c])) - truth;
      e.mean += truth;
      e.bias += off;
      square += off * off;
      e.worst = std::max(e.worst, std::abs(off));
      ++count;
    }
  }
  e.bias /= e.mean;
  e.mean /= count;
  e.rmse = std::sqrt(square / count) / e.mean;
  e.worst /= e.mean;
  return e;
}

inline const std::array<const char*, 6> kinds{"rectangle", "disk",    "ball",
                                              "line",      "polygon", "sun"};

}  // namespace asos::test::true_light
