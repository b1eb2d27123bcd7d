#include "renderer/scene/builtin/house_parts.h"

#include "renderer/scene/builtin/shapes.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos::builtin {

namespace {

constexpr std::uint32_t white_trim = 0xf3efe4;

/// A railing between two points of the floor: two rails and square balusters between them.
void add_railing(Mesh& mesh, glm::vec3 from, glm::vec3 to, int balusters) {
  const glm::vec3 bottom(0.0f, 0.12f, 0.0f), top(0.0f, 0.82f, 0.0f);
  const float half_rail = 0.025f;
  add_beam(mesh, from + bottom, to + bottom, 0.045f, 2.0f * half_rail);
  add_beam(mesh, from + top, to + top, 0.06f, 2.0f * half_rail);
  for (int i = 0; i < balusters; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(balusters);
    const glm::vec3 foot = from + t * (to - from);
    add_beam(mesh, foot + bottom + glm::vec3(0.0f, half_rail, 0.0f),
             foot + top - glm::vec3(0.0f, half_rail, 0.0f), 0.022f, 0.022f, to - from);
  }
}

}  // namespace

void add_tiled_slope(Mesh& mesh, glm::vec2 eave, glm::vec2 ridge, float half_length, float side,
                     int courses) {
  // The outline runs down the underside, from the ridge to the eave, and back up over the tiles.
  // Each course is thick at its lower end and thin at its upper end.
  const auto n = static_cast<std::uint32_t>(courses);
  const glm::vec2 along = (ridge - eave) / static_cast<float>(courses);
  const glm::vec2 out = glm::normalize(glm::vec2(along.y, -along.x));
  std::vector<glm::vec2> outline;
  for (int i = courses; i >= 0; --i) outline.push_back(eave + static_cast<float>(i) * along);
  for (std::uint32_t i = 0; i < n; ++i) {
    outline.push_back(outline[n - i] + 0.09f * out);
    outline.push_back(outline[n - i - 1] + 0.035f * out);
  }
  std::vector<glm::uvec3> cap;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t low = n - i, high = low - 1, thick = n + 1 + 2 * i, thin = thick + 1;
    const std::uint32_t below = i == 0 ? thick : thick - 1;  // where the course below ends
    cap.emplace_back(thin, high, low);
    cap.emplace_back(thin, low, below);
    if (i > 0) cap.emplace_back(thin, below, thick);
  }
  // Both slopes are the same solid, turned to fall towards +z or -z.
  const double turn = side > 0.0f ? -90.0 : 90.0;
  add_extrusion(mesh, outline, cap, 2.0f * half_length,
                glm::mat4(turned({side * half_length, 0.0, 0.0}, turn)));
}

WindowMeshes keep_window(SceneAssembler& stage) {
  constexpr glm::vec2 outer(0.5f, 0.68f), inner(0.42f, 0.6f);
  Mesh frame, pane, shutters;
  add_frame(frame, outer, inner, 0.07f);
  add_box(frame, {-0.018f, -inner.y, 0.015f}, {0.018f, inner.y, 0.055f});
  for (const float side : {-1.0f, 1.0f}) {
    const float from = side < 0.0f ? -inner.x : 0.018f, to = side < 0.0f ? -0.018f : inner.x;
    add_box(frame, {from, 0.1f, 0.018f}, {to, 0.13f, 0.052f});
    const float hinge = side * (outer.x + 0.19f);
    add_box(shutters, {hinge - 0.18f, -outer.y, 0.0f}, {hinge + 0.18f, outer.y, 0.045f});
  }
  add_quad(pane, {-inner.x, -inner.y, 0.012f}, {inner.x, -inner.y, 0.012f},
           {inner.x, inner.y, 0.012f}, {-inner.x, inner.y, 0.012f});
  return {stage.keep("window frame", std::move(frame), stage.paint("window frame", white_trim)),
          stage.keep("window pane", std::move(pane), stage.paint("glass", 0x4c6378, 0.1f)),
          stage.keep("shutters", std::move(shutters), stage.paint("shutters", 0x3f7265, 0.7f))};
}

void place_window(SceneAssembler& stage, const WindowMeshes& window, const glm::dmat4& placement,
                  int number) {
  stage.place(fmt::format("window frame {}", number), window.frame, placement);
  stage.place(fmt::format("window pane {}", number), window.pane, placement);
  stage.place(fmt::format("shutters {}", number), window.shutters, placement);
}

void add_porch(SceneAssembler& stage, float x0, float x1, float wall) {
  constexpr float deck = 0.3f, depth = 2.0f, eave = 2.35f;
  const float edge = wall + depth;
  Mesh floor, wood, courses;
  add_box(floor, {x0, 0.0f, wall + 0.08f}, {x1, deck, edge});
  for (int i = 0; i < 2; ++i) {
    const float z = edge + 0.3f * static_cast<float>(i);
    const float inset = 0.04f * static_cast<float>(i);
    add_box(floor, {-1.3f + inset, 0.0f, z},
            {0.1f - inset, deck - 0.1f * static_cast<float>(i + 1), z + 0.3f});
  }

  // Posts stand inside the deck's edge; the entrance is between the third and the fourth.
  const std::array<float, 5> posts{x0 + 0.1f, -2.85f, -1.4f, 0.2f, x1 - 0.1f};
  const float line = edge - 0.12f;
  for (const float x : posts) {
    add_box(wood, {x - 0.05f, deck, line - 0.05f}, {x + 0.05f, eave, line + 0.05f});
  }
  add_box(wood, {x0, eave, line - 0.07f}, {x1, eave + 0.16f, line + 0.07f});
  const auto rail = [&](float from, float to, int balusters) {
    add_railing(wood, {from + 0.05f, deck, line}, {to - 0.05f, deck, line}, balusters);
  };
  rail(posts[0], posts[1], 9);
  rail(posts[1], posts[2], 10);
  rail(posts[3], posts[4], 8);
  for (const float x : {posts[0], posts[4]}) {
    add_railing(wood, {x, deck, wall}, {x, deck, line - 0.05f}, 7);
  }

  // The lean-to roof: courses that fall from the wall to beyond the posts. The slope's "ridge" is
  // where the roof meets the wall.
  const glm::vec2 low(edge + 0.25f, eave + 0.1f), high(wall, eave + 0.62f);
  add_tiled_slope(courses, low, high, 0.5f * (x1 - x0) + 0.15f, 1.0f, 4);
  const int roof_mesh =
      stage.keep("porch roof", std::move(courses), stage.paint("porch tiles", 0x96604a, 0.85f));
  stage.place("porch roof", roof_mesh, turned({0.5 * (x0 + x1), 0.0, 0.0}, 0.0));
  stage.add("porch floor", std::move(floor), stage.paint("boards", 0xb59a78, 0.9f));
  stage.add("porch", std::move(wood), stage.paint("porch wood", white_trim, 0.7f));
}

void add_sand(Mesh& mesh) {
  constexpr int columns = 30, rows = 19;
  // The spacing of the grid's lines grows outwards.
  const auto line = [](int i, int count, double reach) {
    const double t = 2.0 * i / count - 1.0;
    return reach * std::sinh(6.0 * t) / std::sinh(6.0);
  };
  const auto height = [](glm::dvec2 p) {
    const glm::dvec2 outside = glm::max(glm::abs(p - glm::dvec2(2.0, 1.0)) - 11.0, 0.0);
    const double rise = glm::smoothstep(0.0, 40.0, glm::length(outside));
    return 0.9 * rise * (1.0 + std::sin(0.06 * p.x + 0.02 * p.y) * std::sin(0.05 * p.y + 1.0));
  };
  for (int k = 0; k <= rows; ++k) {
    for (int i = 0; i <= columns; ++i) {
      const glm::dvec2 p(line(i, columns, 2000.0) + 2.0, line(k, rows, 900.0) + 1.0);
      constexpr double step = 0.01;
      const glm::dvec2 slope(
          (height(p + glm::dvec2(step, 0)) - height(p - glm::dvec2(step, 0))) / (2.0 * step),
          (height(p + glm::dvec2(0, step)) - height(p - glm::dvec2(0, step))) / (2.0 * step));
      mesh.positions.emplace_back(p.x, height(p), p.y);
      mesh.normals.push_back(glm::normalize(glm::vec3(-slope.x, 1.0, -slope.y)));
      mesh.tangents.emplace_back(glm::normalize(glm::vec3(1.0, slope.x, 0.0)), 1.0f);
      mesh.texcoords[0].emplace_back(p.x, p.y);
    }
  }
  for (std::uint32_t k = 0; k < rows; ++k) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = k * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.emplace_back(a, b, b + 1);
      mesh.triangles.emplace_back(a, b + 1, a + 1);
    }
  }
}

void add_gazebo(SceneAssembler& stage, glm::dvec3 place) {
  constexpr float radius = 1.75f, deck = 0.25f, eave = 2.3f;
  const auto corner = [](int i, float r) {
    const float turn = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / 8.0f;
    return glm::vec2(r * std::sin(turn), r * std::cos(turn));
  };
  Mesh floor, wood, roof;
  std::vector<glm::vec2> outline;
  for (int i = 0; i < 8; ++i) {
    const glm::vec2 p = corner(i, radius + 0.15f);
    outline.emplace_back(p.x, -p.y);  // the prism's z axis points up, its y axis along -z
  }
  const glm::mat4 upwards({1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
  add_prism(floor, outline, deck, upwards);

  for (int i = 0; i < 8; ++i) {
    const glm::vec2 p = corner(i, radius), q = corner(i + 1, radius);
    const glm::vec3 foot(p.x, deck, p.y), next(q.x, deck, q.y);
    add_beam(wood, foot, foot + glm::vec3(0.0f, eave - deck, 0.0f), 0.09f, 0.09f,
             {-p.x, 0.0f, -p.y});
    const glm::vec3 inset = 0.045f * glm::normalize(next - foot);
    const bool entrance = i == 5;
    if (!entrance) add_railing(wood, foot + inset, next - inset, 5);
  }
  add_frustum(roof, {0.0f, eave, 0.0f}, {0.0f, eave + 1.25f, 0.0f}, radius + 0.4f, 0.0f, 40);
  Mesh finial;
  add_sphere(finial, {0.0f, eave + 1.3f, 0.0f}, 0.08f, 2);

  const glm::dmat4 placement = turned(place, 0.0);
  const auto add = [&](const std::string& name, Mesh mesh, int material) {
    stage.place(name, stage.keep(name, std::move(mesh), material), placement);
  };
  add("gazebo floor", std::move(floor), stage.paint("gazebo floor", 0xb59a78, 0.9f));
  add("gazebo", std::move(wood), stage.paint("gazebo wood", white_trim, 0.7f));
  add("gazebo roof", std::move(roof), stage.paint("gazebo roof", 0x5b7f8f, 0.7f));
  add("gazebo finial", std::move(finial), stage.paint("finial", 0xd8b25a, 0.4f));
}

}  // namespace asos::builtin
