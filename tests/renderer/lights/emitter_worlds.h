#pragma once

#include "renderer/lights/emitters.h"
#include "renderer/lights/prepared_light.h"
#include "tests/support/tiny_world.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

// Emissive surfaces, and the power of the lights made from them.

namespace asos::test {

inline Material glow(glm::vec3 nits) {
  Material m = matte(glm::vec3(0.5f));
  m.emissive = nits;
  return m;
}

/// The material's emissive factor and strength everywhere.
inline glm::vec3 plain_emission(const World& world, std::uint32_t triangle, float, float) {
  const Material& m = world.material_of(triangle);
  return m.emissive * m.emissive_strength;
}

/// Triangles with unshared vertices as one part.
inline void add_soup(World& world, const std::vector<std::array<glm::vec3, 3>>& soup,
                     const Material& material) {
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (const auto& t : soup) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const glm::vec3& p : t) vertices.push_back({p, {0, 0, 1}, {0, 0}});
    triangles.emplace_back(first, first + 1, first + 2);
  }
  add_part(world, vertices, triangles, material);
}

inline void add_square(std::vector<std::array<glm::vec3, 3>>& soup, glm::vec3 corner, glm::vec3 a,
                       glm::vec3 b) {
  soup.push_back({corner, corner + a, corner + a + b});
  soup.push_back({corner, corner + a + b, corner + b});
}

/// A box that faces outwards.
inline void add_box(std::vector<std::array<glm::vec3, 3>>& soup, glm::vec3 lo, glm::vec3 size) {
  const glm::vec3 x(size.x, 0, 0);
  const glm::vec3 y(0, size.y, 0);
  const glm::vec3 z(0, 0, size.z);
  add_square(soup, lo, y, x);
  add_square(soup, lo, z, y);
  add_square(soup, lo, x, z);
  add_square(soup, lo + z, x, y);
  add_square(soup, lo + x, y, z);
  add_square(soup, lo + y, z, x);
}

/// The side of a cylinder around the y axis, facing outwards, with or without caps.
inline std::vector<std::array<glm::vec3, 3>> cylinder(float radius, float length, int sides,
                                                      bool ends) {
  std::vector<std::array<glm::vec3, 3>> soup;
  const auto at = [&](int i, float y) {
    const float phi = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i % sides) /
                      static_cast<float>(sides);
    return glm::vec3(radius * std::cos(phi), y, -radius * std::sin(phi));
  };
  const glm::vec3 top(0, 0.5f * length, 0);
  for (int i = 0; i < sides; ++i) {
    const glm::vec3 a = at(i, -top.y);
    const glm::vec3 b = at(i + 1, -top.y);
    const glm::vec3 c = at(i + 1, top.y);
    const glm::vec3 d = at(i, top.y);
    soup.push_back({a, b, c});
    soup.push_back({a, c, d});
    if (!ends) continue;
    soup.push_back({top, d, c});
    soup.push_back({-top, b, a});
  }
  return soup;
}

inline double area_of(const World& world, std::uint32_t part) {
  const Part& p = world.parts[part];
  double area = 0.0;
  for (std::uint32_t i = 0; i < p.triangle_count; ++i) {
    const glm::uvec3 t = world.triangles[p.first_triangle + i];
    const glm::dvec3 a(world.positions[t.x]);
    area += 0.5 * glm::length(glm::cross(glm::dvec3(world.positions[t.y]) - a,
                                         glm::dvec3(world.positions[t.z]) - a));
  }
  return area;
}

/// The flux (red) of a light through a sphere around it, by integrating the irradiance on its
/// inside.
inline double flux_through_sphere(const Light& light, glm::dvec3 middle, double radius) {
  constexpr int rows = 96;
  constexpr int columns = 192;
  const PreparedLight prepared = prepare_light(light);
  double sum = 0.0;
  for (int i = 0; i < rows; ++i) {
    const double z = (2.0 * i + 1.0) / rows - 1.0;  // equal areas
    for (int k = 0; k < columns; ++k) {
      const double phi = 2.0 * std::numbers::pi * (k + 0.5) / columns;
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 out(r * std::cos(phi), r * std::sin(phi), z);
      sum += unshadowed_irradiance(prepared, {middle + radius * out, -out, -out}).r;
    }
  }
  return sum * 4.0 * std::numbers::pi * radius * radius / (rows * columns);
}

inline double total_flux(const std::vector<Light>& lights, glm::dvec3 middle, double radius) {
  double sum = 0.0;
  for (const Light& light : lights) sum += flux_through_sphere(light, middle, radius);
  return sum;
}

}  // namespace asos::test
