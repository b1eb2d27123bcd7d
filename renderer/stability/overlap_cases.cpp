#include "renderer/scene/builtin/shapes.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Surfaces at the same place, nearly at the same place, and through each other.

namespace asos::stability {
namespace {

constexpr const char* overlap_group = "overlaps";

Face lifted(Face face, double z, float colour) {
  for (glm::dvec3& p : face.corners) p.z += z;
  face.colour = colour;
  return face;
}

/// Compares the scene of some faces with exact visibility of those that should be visible.
Result<Outcome> seen(const std::vector<Face>& faces, const std::vector<Face>& visible, int edges,
                     double more_bound = 0.0, const std::string& more = "") {
  const PictureView view{card_camera(), picture_side, picture_side};
  return worst_pixel(
      {"radiance of the worst of 16x16 pixels",
       rounding_bound(view, {1.5, 2.5, edges, 1.0}) + more_bound, rounding_reason + more},
      render(scene_of(faces, view.camera), settings_of(picture_side, picture_side)),
      [&](int x, int y) { return faces_radiance(view, visible, x, y); });
}

/// Two faces so near each other that each pixel may show either of them, but no mixture.
Result<Outcome> either_seen(const Face& first, const Face& second, const std::string& reason) {
  const PictureView view{card_camera(), picture_side, picture_side};
  const auto picture =
      render(scene_of({first, second}, view.camera), settings_of(picture_side, picture_side));
  if (!picture) return unexpected(picture.error());
  return worst_pixel({"radiance of the worst of 16x16 pixels, off the nearer of two",
                      rounding_bound(view, {1.5, 2.5, 2, 1.0}), rounding_reason + reason},
                     picture, [&](int x, int y) {
                       const double a = faces_radiance(view, {first}, x, y);
                       const double b = faces_radiance(view, {second}, x, y);
                       const double got = picture->at(x, y);
                       return std::abs(got - a) < std::abs(got - b) ? a : b;
                     });
}

void add_coincident(std::vector<Case>& cases) {
  cases.push_back({"two faces in one place, of one colour", overlap_group, true, [] {
                     return seen({tilted_card(), tilted_card()}, {tilted_card()}, 2);
                   }});
  cases.push_back({"a hundred faces in one place", overlap_group, true,
                   [] { return seen(std::vector<Face>(100, tilted_card()), {tilted_card()}, 2); }});
  cases.push_back({"two faces in one place, of two greys", overlap_group, true, [] {
                     return either_seen(tilted_card(1.0f), tilted_card(0.75f),
                                        "; either face may be seen");
                   }});
  cases.push_back(
      {"a doubled wall, each face single-sided", overlap_group, true, [] {
         const PictureView view{card_camera(), picture_side, picture_side};
         Scene scene = scene_of({}, view.camera);
         const Face front = tilted_card(1.0f);
         for (const bool is_front : {false, true}) {
           Material material = unlit(is_front ? 1.0f : 0.0f);
           material.double_sided = false;
           std::vector<glm::dvec3> corners = front.corners;
           if (!is_front) std::swap(corners[1], corners[3]);
           place(scene, mesh_of(corners), material);
         }
         return worst_pixel(
             {"radiance of the worst of 16x16 pixels", rounding_bound(view, {1.5, 2.5, 2, 1.0}),
              std::string(rounding_reason) + "; the back in the same place is not seen"},
             render(scene, settings_of(picture_side, picture_side)),
             [&](int x, int y) { return faces_radiance(view, {front}, x, y); });
       }});
}

void add_near(std::vector<Case>& cases) {
  for (const double gap : {1e-3, 1e-4, 1e-5}) {
    cases.push_back(
        {fmt::format("a white face {:g} before a black one", gap), overlap_group, true, [gap] {
           // Perspective shrinks the farther face by the ratio of the gap to the distance.
           const Face white = lifted(tilted_card(), gap, 1.0f);
           return seen({tilted_card(0.0f), white}, {white}, 2, gap,
                       "; the gap is more than the 12 roundings of a distance of 4; "
                       "perspective shrinks the farther face by the gap's share of it");
         }});
  }
  cases.push_back({"a white face 1e-6 before a grey one", overlap_group, true, [] {
                     const Face white = lifted(tilted_card(), 1e-6, 1.0f);
                     return either_seen(
                         tilted_card(0.75f), white,
                         "; the gap is less than 12 roundings of a distance of 4, so "
                         "that either face may be seen");
                   }});
  cases.push_back(
      {"a decal 1e-4 above a wall", overlap_group, true, [] {
         const Face decal{
             {{-0.5, -0.4, 1e-4}, {0.45, -0.5, 1e-4}, {0.5, 0.5, 1e-4}, {-0.4, 0.4, 1e-4}}, 1.0f};
         const PictureView view{card_camera(), picture_side, picture_side};
         const Face wall{{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, 0.0f};
         return worst_pixel(
             {"radiance of the worst of 16x16 pixels", rounding_bound(view, {4.0, 4.0, 2, 1.0}),
              rounding_reason},
             render(scene_of({wall, decal}, view.camera), settings_of(picture_side, picture_side)),
             [&](int x, int y) { return coverage(view, decal.corners, x, y); });
       }});
}

/// A box on a floor, sunk `deep` below its surface. Only the box's top and front are visible
/// besides the floor.
Result<Outcome> sunk_box(double deep) {
  const PictureView view{parallel({0, 4, 4}, {0, 0, 0}, 3.0), picture_side, picture_side};
  Scene scene = scene_of({{{{-8, 0, 8}, {8, 0, 8}, {8, 0, -8}, {-8, 0, -8}}, 0.0f}}, view.camera);
  Mesh box;
  builtin::add_box(box, {-0.6f, static_cast<float>(-deep), -0.4f}, {0.7f, 0.8f, 0.45f});
  place(scene, box, unlit(1.0f));
  const std::vector<glm::dvec3> front{
      {-0.6, 0, 0.45}, {0.7, 0, 0.45}, {0.7, 0.8, 0.45}, {-0.6, 0.8, 0.45}};
  const std::vector<glm::dvec3> top{
      {-0.6, 0.8, 0.45}, {0.7, 0.8, 0.45}, {0.7, 0.8, -0.4}, {-0.6, 0.8, -0.4}};
  return worst_pixel({"radiance of the worst of 16x16 pixels",
                      rounding_bound(view, {8.0, 1.0, 3, 1.0}), rounding_reason},
                     render(scene, settings_of(picture_side, picture_side)), [&](int x, int y) {
                       return coverage(view, front, x, y) + coverage(view, top, x, y);
                     });
}

void add_through(std::vector<Case>& cases) {
  for (const double deep : {0.1, 1e-3, 1e-6}) {
    cases.push_back({fmt::format("a box sunk {:g} into a floor", deep), overlap_group, true,
                     [deep] { return sunk_box(deep); }});
  }
  cases.push_back(
      {"a box that touches a floor", overlap_group, true, [] { return sunk_box(0.0); }});
  cases.push_back(
      {"two cards through each other", overlap_group, true, [] {
         // One leans left, one right; the nearer half of each is visible.
         const double a = 0.8;
         const Face one{{{-a, -0.7, -a}, {a, -0.7, a}, {a, 0.7, a}, {-a, 0.7, -a}}, 1.0f};
         const Face other{{{-a, -0.7, a}, {a, -0.7, -a}, {a, 0.7, -a}, {-a, 0.7, a}}, 0.0f};
         const Face right{{{0, -0.7, 0}, {a, -0.7, a}, {a, 0.7, a}, {0, 0.7, 0}}, 1.0f};
         const Face left{{{-a, -0.7, a}, {0, -0.7, 0}, {0, 0.7, 0}, {-a, 0.7, a}}, 0.0f};
         return seen({one, other}, {left, right}, 3);
       }});
  cases.push_back(
      {"two cards through each other at 1e-4 radians", overlap_group, true, [] {
         const double a = 0.8;
         const double z = 0.8e-4;
         const Face one{{{-a, -0.7, -z}, {a, -0.7, z}, {a, 0.7, z}, {-a, 0.7, -z}}, 1.0f};
         const Face other{{{-a, -0.7, z}, {a, -0.7, -z}, {a, 0.7, -z}, {-a, 0.7, z}}, 0.0f};
         const Face right{{{0, -0.7, 0}, {a, -0.7, z}, {a, 0.7, z}, {0, 0.7, 0}}, 1.0f};
         const Face left{{{-a, -0.7, z}, {0, -0.7, 0}, {0, 0.7, 0}, {-a, 0.7, z}}, 0.0f};
         // Depth has an error of 12 roundings of 4; the faces diverge by 2e-4 per unit.
         const PictureView view{card_camera(), picture_side, picture_side};
         const double smear = 12.0 * rounding * 4.0 / 1e-4 * view.pixels_per_unit() / 4.0;
         return seen({one, other}, {left, right}, 3, smear + 1e-4,
                     "; depths that err by 12 roundings of 4 meet where faces 2e-4 a "
                     "unit apart differ by less; perspective moves edges by 1e-4");
       }});
}

}  // namespace

std::vector<Case> overlap_cases() {
  std::vector<Case> cases;
  add_coincident(cases);
  add_near(cases);
  add_through(cases);
  return cases;
}

}  // namespace asos::stability
