#include "renderer/scene/builtin/shapes.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Invalid and extreme meshes: slivers, degenerate triangles, bad normals, too many parts.

namespace asos::stability {
namespace {

constexpr const char* mesh_group = "meshes";

/// Compares a mesh that covers exactly the tilted card with the card's closed form.
Result<Outcome> card_of(const Mesh& mesh, const std::string& more = "") {
  const PictureView view{card_camera(), picture_side, picture_side};
  Scene scene = scene_of({}, view.camera);
  place(scene, mesh, unlit(1.0f));
  const Face card = tilted_card();
  return worst_pixel({"radiance of the worst of 16x16 pixels",
                      rounding_bound(view, {1.5, 2.5, 2, 0.65}), rounding_reason + more},
                     render(scene, settings_of(picture_side, picture_side)),
                     [&](int x, int y) { return faces_radiance(view, {card}, x, y); });
}

glm::vec3 on_card(double u, double v) {
  const std::vector<glm::dvec3> c = tilted_card().corners;
  return glm::vec3(c[0] + u * (c[1] - c[0]) + v * (c[3] - c[0]));
}

/// The card as strips between the given heights, each of two triangles.
Mesh strips(const std::vector<double>& heights) {
  Mesh mesh;
  for (const double v : heights) {
    mesh.positions.push_back(on_card(0.0, v));
    mesh.positions.push_back(on_card(1.0, v));
  }
  for (std::uint32_t i = 0; i + 1 < heights.size(); ++i) {
    mesh.triangles.emplace_back(2 * i, 2 * i + 1, 2 * i + 3);
    mesh.triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 2);
  }
  return mesh;
}

Mesh with_zero_areas() {
  Mesh mesh = mesh_of(tilted_card().corners);
  mesh.positions.push_back(on_card(0.5, 0.5));
  mesh.positions.push_back(on_card(0.25, 0.25));
  const glm::uvec3 degenerate[] = {{0, 0, 0}, {0, 1, 1}, {2, 0, 2}, {0, 4, 2}, {0, 5, 4}};
  mesh.triangles.insert(mesh.triangles.end(), std::begin(degenerate), std::end(degenerate));
  return mesh;
}

/// A triangle's side is split by vertices that its neighbour does not share.
Mesh t_junctions(double step) {
  const std::vector<glm::dvec3> c = tilted_card().corners;
  Mesh mesh;
  mesh.positions = {glm::vec3(c[0]), glm::vec3(c[1]), glm::vec3(c[2]), glm::vec3(c[3])};
  mesh.triangles = {{0, 1, 2}};
  std::uint32_t last = 0;
  for (double t = step; t < 1.0; t += step) {
    mesh.positions.emplace_back(c[0] + t * (c[2] - c[0]));
    const auto next = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles.emplace_back(last, next, 3);
    last = next;
  }
  mesh.triangles.emplace_back(last, 2, 3);
  return mesh;
}

void add_triangles(std::vector<Case>& cases) {
  cases.push_back({"a card cut by slivers of aspect 1e6", mesh_group, true, [] {
                     return card_of(strips({0.0, 0.3, 0.300001, 0.5, 0.500001, 0.500002, 1.0}));
                   }});
  cases.push_back(
      {"a lone sliver of aspect 1e6 adds no more than its area", mesh_group, true, [] {
         const Face sliver{{{-0.4375, 0, 0}, {0.4375, 0, 0}, {0.4375, 8.75e-7, 0}}, 1.0f};
         const PictureView view{parallel({0, 1e-7, 1}, {0, 1e-7, 0}, 1.0), picture_side,
                                picture_side};
         return worst_pixel(
             {"radiance of the worst of 16x16 pixels", rounding_bound(view, {0.5, 1.0, 3, 0.65}),
              rounding_reason},
             render(scene_of({sliver}, view.camera), settings_of(picture_side, picture_side)),
             [&](int x, int y) { return faces_radiance(view, {sliver}, x, y); });
       }});
  cases.push_back({"zero-area triangles on a card", mesh_group, true,
                   [] { return card_of(with_zero_areas()); }});
  cases.push_back({"a card of triangles that share no vertex", mesh_group, true, [] {
                     const Mesh shared = strips({0.0, 0.2, 0.4, 0.6, 0.8, 1.0});
                     Mesh soup;
                     for (const glm::uvec3 t : shared.triangles) {
                       const auto first = static_cast<std::uint32_t>(soup.positions.size());
                       for (int k = 0; k < 3; ++k) soup.positions.push_back(shared.positions[t[k]]);
                       soup.triangles.emplace_back(first, first + 1, first + 2);
                     }
                     return card_of(soup);
                   }});
  cases.push_back({"T-junctions at exact places", mesh_group, true,
                   [] { return card_of(t_junctions(0.125)); }});
  cases.push_back({"T-junctions off the edge by rounding", mesh_group, true, [] {
                     return card_of(t_junctions(0.137), "; a crack between is that wide at most");
                   }});
  cases.push_back({"vertices at infinity that no triangle uses", mesh_group, true, [] {
                     Mesh mesh = mesh_of(tilted_card().corners);
                     mesh.positions.emplace_back(infinite, -infinite, not_a_number);
                     mesh.normals.assign(5, glm::vec3(0, 0, 1));
                     return card_of(mesh);
                   }});
  cases.push_back({"a vertex at infinity is refused", mesh_group, true, [] {
                     Mesh mesh = mesh_of(tilted_card().corners);
                     mesh.positions[1].x = std::numeric_limits<float>::infinity();
                     Scene scene = scene_of({}, card_camera());
                     place(scene, mesh, unlit(1.0f));
                     const bool refused = !render(scene, settings_of(picture_side, picture_side));
                     return plain_value({"refused with a reason (1: yes)", 0.0, "yes or no"}, 1.0,
                                        refused ? 1.0 : 0.0);
                   }});
}

/// The still life's meshes, with normals computed by `normal` from a flat face's own.
Scene with_normals(const std::function<glm::vec3(glm::vec3)>& normal) {
  Scene scene = still_life();
  for (Mesh& mesh : scene.meshes) {
    Mesh flat;
    for (const glm::uvec3 t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(flat.positions.size());
      const glm::vec3 a = mesh.positions[t.x];
      const glm::vec3 n =
          glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
      for (int k = 0; k < 3; ++k) flat.positions.push_back(mesh.positions[t[k]]);
      flat.normals.insert(flat.normals.end(), 3, normal(n));
      flat.triangles.emplace_back(first, first + 1, first + 2);
    }
    flat.material = mesh.material;
    mesh = flat;
  }
  return scene;
}

void add_normals(std::vector<Case>& cases) {
  const auto compare = [](const std::function<glm::vec3(glm::vec3)>& normal) {
    const RenderSettings settings = settings_of(24, picture_side);
    const Scene sound = with_normals([](glm::vec3 n) { return n; });
    return worst_difference({"radiance of the pixel that differs most", 0.0,
                             "a normal that says nothing, or the opposite, gives way to the "
                             "triangle's own: the same bits"},
                            render(sound, settings), render(with_normals(normal), settings));
  };
  cases.push_back({"normals that point inwards", mesh_group, true,
                   [compare] { return compare([](glm::vec3 n) { return -n; }); }});
  cases.push_back({"normals that are not numbers", mesh_group, true, [compare] {
                     return compare([](glm::vec3) { return glm::vec3(not_a_number); });
                   }});
  cases.push_back({"normals of length 0", mesh_group, true,
                   [compare] { return compare([](glm::vec3) { return glm::vec3(0.0f); }); }});
}

/// Compares a mesh of one colour by ASOS with exact visibility of another mesh.
Result<Outcome> against_beam(const Mesh& expected, const Mesh& mesh, bool double_sided) {
  const PictureView view{look_at({1.5, 2.0, 4.0}, {0, 0, 0}, 40.0), picture_side, picture_side};
  const auto picture = [&](const Mesh& shown, Method method) {
    Scene scene = scene_of({}, view.camera);
    Material material = unlit(1.0f);
    material.double_sided = double_sided;
    place(scene, shown, material);
    RenderSettings settings = settings_of(picture_side, picture_side, 5);
    settings.method = method;
    return render(scene, settings);
  };
  // Up to three corners lie in a pixel. Each may leave a finest cell unresolved, 1/1024 at MAX 5.
  return worst_difference({"radiance of the pixel that differs most from exact visibility",
                           rounding_bound(view, {1.5, 2.5, 8, 0.65}) + 0.65 * 3.0 / 1024.0,
                           std::string(rounding_reason) +
                               "; and at MAX 5 three corners in a pixel may each leave a finest "
                               "cell unresolved"},
                          picture(expected, Method::beam), picture(mesh, Method::asos));
}

Mesh turned_inside_out(Mesh mesh) {
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  for (glm::vec3& n : mesh.normals) n = -n;
  return mesh;
}

void add_topology(std::vector<Case>& cases) {
  cases.push_back({"a fan of seven blades on one edge", mesh_group, true, [] {
                     Mesh fan;
                     fan.positions = {{0, -0.75f, 0}, {0, 0.75f, 0}};
                     for (int i = 0; i < 7; ++i) {
                       const double a = 2.0 * std::numbers::pi * (i + 0.2) / 7.0;
                       fan.positions.emplace_back(std::cos(a), 0.1 * i - 0.3, std::sin(a));
                       fan.triangles.emplace_back(0, 1, i + 2);
                     }
                     return against_beam(fan, fan, true);
                   }});
  Mesh box;
  builtin::add_box(box, glm::vec3(-0.75f), glm::vec3(0.75f));
  cases.push_back({"an open box", mesh_group, true, [box] {
                     Mesh open = box;
                     open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 4);
                     return against_beam(open, open, true);
                   }});
  cases.push_back({"a box turned inside out, single-sided", mesh_group, true,
                   [box] { return against_beam(box, turned_inside_out(box), false); }});
  cases.push_back(
      {"a box, every other triangle turned over, single-sided", mesh_group, true, [box] {
         Mesh holed = box;
         for (std::size_t i = 0; i < holed.triangles.size(); i += 2)
           std::swap(holed.triangles[i].y, holed.triangles[i].z);
         return against_beam(holed, holed, false);
       }});
  cases.push_back(
      {"a box mirrored by its node", mesh_group, true, [box] {
         Scene scene = scene_of({}, look_at({1.5, 2.0, 4.0}, {0, 0, 0}, 40.0));
         Material material = unlit(1.0f);
         material.double_sided = false;
         place(scene, box, material);
         const auto sound = render(scene, settings_of(picture_side, picture_side));
         scene.instances[0].world_from_mesh = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
         const PictureView view{scene.cameras[0], picture_side, picture_side};
         return worst_difference({"radiance of the pixel that differs most",
                                  2.0 * rounding_bound(view, {1.5, 2.5, 3, 0.65}), rounding_reason},
                                 sound, render(scene, settings_of(picture_side, picture_side)));
       }});
  cases.push_back(
      {"a box that its node squeezes flat", mesh_group, true, [] {
         Mesh cube;
         builtin::add_box(cube, glm::vec3(-0.5f), glm::vec3(0.5f));
         const PictureView view{card_camera(), picture_side, picture_side};
         Scene scene = scene_of({}, view.camera);
         place(scene, cube, unlit(1.0f), glm::scale(glm::dmat4(1.0), glm::dvec3(1.1, 0.9, 0.0)));
         const Face flat{{{-0.55, -0.45, 0}, {0.55, -0.45, 0}, {0.55, 0.45, 0}, {-0.55, 0.45, 0}},
                         1.0f};
         return worst_pixel({"radiance of the worst of 16x16 pixels",
                             rounding_bound(view, {1.0, 2.5, 2, 0.65}), rounding_reason},
                            render(scene, settings_of(picture_side, picture_side)),
                            [&](int x, int y) { return faces_radiance(view, {flat}, x, y); });
       }});
  cases.push_back({"a scene without any triangle", mesh_group, true, [] {
                     return worst_pixel({"radiance of the worst of 16x16 pixels", 2.0 * rounding,
                                         "the background's float, and nothing is computed"},
                                        render(scene_of({}, card_camera()),
                                               settings_of(picture_side, picture_side)),
                                        [](int, int) { return background; });
                   }});
}

/// A ball of 8 n^2 triangles and radius 0.4 in a picture of one pixel.
Result<Outcome> ball_in_a_pixel(int n, int max_level) {
  Scene scene = scene_of({}, parallel({0, 0, 2}, {0, 0, 0}, 1.0));
  Mesh ball;
  builtin::add_sphere(ball, {0.03f, 0.02f, 0.0f}, 0.4f, n);
  place(scene, std::move(ball), unlit(1.0f));
  const double finest = std::ldexp(1.0, -max_level);
  // The outline has 4 n chords, so its area is less than the disk's by (2 pi / 4 n)^2 / 6 of it.
  const double chord = 2.0 * std::numbers::pi / (4.0 * n);
  const double disk = std::numbers::pi * 0.16;
  return one_value(
      {"radiance of the pixel", 0.65 * (4.0 * finest + disk * chord * chord / 6.0),
       fmt::format("MAX {}: a convex outline crosses at most 4 times 2^MAX finest cells, each of "
                   "4^-MAX of the pixel; and what the chords cut off the disk",
                   max_level)},
      background + disk * (1.0 - background), render(scene, settings_of(1, 1, max_level)),
      [](const Picture& p) { return p.at(0, 0); });
}

void add_many(std::vector<Case>& cases) {
  cases.push_back({"a ball of 131,072 triangles in one pixel", mesh_group, true,
                   [] { return ball_in_a_pixel(128, 6); }});
  cases.push_back({"a ball of 10 million triangles in one pixel", mesh_group, false,
                   [] { return ball_in_a_pixel(1119, 8); }});
  cases.push_back(
      {"ten thousand nodes of one triangle each", mesh_group, true, [] {
         const PictureView view{card_camera(), picture_side, picture_side};
         Scene scene = scene_of({}, view.camera);
         const double step = 1.0 / 128.0;  // 100 x 50 squares of two triangles
         Mesh half = mesh_of({{0, 0, 0}, {step, 0, 0}, {0, step, 0}});
         place(scene, half, unlit(1.0f), glm::translate(glm::dmat4(1.0), {-0.5, -0.25, 0}));
         for (int i = 1; i < 10000; ++i) {
           Instance node = scene.instances[0];
           const glm::dvec3 at(-0.5 + step * (i / 2 % 100), -0.25 + step * (i / 200), 0);
           node.world_from_mesh = glm::translate(glm::dmat4(1.0), at);
           if (i % 2 == 1)  // the square's other half
             node.world_from_mesh =
                 glm::translate(glm::dmat4(1.0), at + glm::dvec3(step, step, 0)) *
                 glm::scale(glm::dmat4(1.0), glm::dvec3(-1, -1, 1));
           scene.instances.push_back(node);
         }
         const Face card{{{-0.5, -0.25, 0},
                          {-0.5 + 100 * step, -0.25, 0},
                          {-0.5 + 100 * step, -0.25 + 50 * step, 0},
                          {-0.5, -0.25 + 50 * step, 0}},
                         1.0f};
         return worst_pixel({"radiance of the worst of 16x16 pixels",
                             rounding_bound(view, {1.0, 2.5, 2, 0.65}), rounding_reason},
                            render(scene, settings_of(picture_side, picture_side)),
                            [&](int x, int y) { return faces_radiance(view, {card}, x, y); });
       }});
}

}  // namespace

std::vector<Case> mesh_cases() {
  std::vector<Case> cases;
  add_triangles(cases);
  add_normals(cases);
  add_topology(cases);
  add_many(cases);
  return cases;
}

}  // namespace asos::stability
