#pragma once

#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// Scenes of glass without reflection in front of emissive walls, and small pictures of them.

namespace asos::test::glass {

inline constexpr int picture_side = 12;  // of a picture, in pixels
inline constexpr std::array methods{Method::asos, Method::sobol};

/// Glass without reflection, except for total reflection.
inline Material clear(float index) {
  Material m = matte(glm::vec3(1.0f));
  m.roughness = 0.0f;
  m.specular = 0.0f;
  m.transmission = 1.0f;
  m.volume.thickness = 1.0f;
  m.ior = index;
  return m;
}

inline Material wall(glm::vec3 colour) {
  Material m = unlit(colour);
  m.double_sided = true;
  return m;
}

/// A convex solid around an inner point, as one part, with faces given by their corners.
inline void add_solid(World& world, const std::vector<std::vector<glm::vec3>>& faces,
                      glm::vec3 within, const Material& material) {
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (std::vector<glm::vec3> face : faces) {
    glm::vec3 n = glm::normalize(glm::cross(face[1] - face[0], face[2] - face[0]));
    if (glm::dot(n, face[0] - within) < 0.0f) {
      std::reverse(face.begin(), face.end());
      n = -n;
    }
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const glm::vec3 p : face) vertices.push_back({p, n, {0, 0}});
    for (std::uint32_t k = 2; k < face.size(); ++k)
      triangles.emplace_back(first, first + k - 1, first + k);
  }
  add_part(world, vertices, triangles, material);
}

/// An outline in the xz plane, extruded along y.
inline void add_bar(World& world, const std::vector<glm::dvec2>& outline, float half_height,
                    const Material& material) {
  std::vector<glm::vec3> low, high;
  glm::vec3 middle(0.0f);
  for (const glm::dvec2 p : outline) {
    low.emplace_back(p.x, -half_height, p.y);
    high.emplace_back(p.x, half_height, p.y);
    middle += low.back() + high.back();
  }
  std::vector<std::vector<glm::vec3>> faces{low, high};
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t k = (i + 1) % low.size();
    faces.push_back({low[i], low[k], high[k], high[i]});
  }
  add_solid(world, faces, middle / static_cast<float>(2 * low.size()), material);
}

/// A plate through the origin, rotated about y, so that rays along -z hit it at this angle.
inline void add_plate(World& world, double angle, double thickness, const Material& material) {
  const glm::dvec2 out(std::sin(angle), std::cos(angle)), along(std::cos(angle), -std::sin(angle));
  const glm::dvec2 half = 0.5 * thickness * out;
  add_bar(world, {half - 5.0 * along, half + 5.0 * along, -half + 5.0 * along, -half - 5.0 * along},
          5.0f, material);
}

/// White where x is below an edge, black elsewhere.
inline void add_edge(World& world, double x, double z, double reach = 10.0) {
  const auto at = static_cast<float>(x), far = static_cast<float>(reach);
  const auto depth = static_cast<float>(z);
  add_quad(world, {at - far, -far, depth}, {far, 0, 0}, {0, 2 * far, 0}, wall(glm::vec3(1.0f)));
  add_quad(world, {at, -far, depth}, {far, 0, 0}, {0, 2 * far, 0}, wall(glm::vec3(0.0f)));
}

inline std::vector<glm::vec3> picture(const RenderScene& scene, const Camera& camera, Method method,
                                      std::shared_ptr<const Sky> sky = nullptr,
                                      double eps = AsosSettings{}.eps, int spp = 256) {
  RenderSettings settings =
      make_settings(picture_side, picture_side, method, method == Method::asos ? 1 : spp);
  settings.asos.eps = eps;
  settings.sky = std::move(sky);
  return render_picture(scene, camera, settings).film.radiance;
}

inline glm::dvec3 mean(const std::vector<glm::vec3>& pixels) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3 p : pixels) sum += glm::dvec3(p);
  return sum / static_cast<double>(pixels.size());
}

/// Position of the edge between white on the left and black in a picture of this width.
inline double edge_in(const std::vector<glm::vec3>& pixels, double width) {
  return (mean(pixels).y - 0.5) * width;
}

}  // namespace asos::test::glass
