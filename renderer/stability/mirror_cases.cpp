#include "renderer/shading/dfr.h"
#include "renderer/shading/environment.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Mirrors: extreme defocusing ratios, endless bounces, and angles and shapes that leave a reflected
// pyray without width or apex.

namespace asos::stability {
namespace {

constexpr const char* mirror_group = "mirrors";
constexpr const char* worst_of_small = "radiance of the worst of 8x8 pixels";

/// The surroundings replace the reflection where no bounce follows.
constexpr double unfollowed = background;

const Measure all_of_the_sky{worst_of_small, 64.0 * rounding,
                             "white metal in an even sky returns all of it, 0.35: it is not to be "
                             "told from the sky, but for roundings"};

/// A square mirror in y = 0 around the origin, `half` wide each way.
Scene floor_mirror(const Material& material, const Camera& camera, double half = 64.0) {
  Scene scene = scene_of({}, camera);
  place(scene, mesh_of({{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}}),
        material);
  add_dark_light(scene);
  return scene;
}

/// Looks at the mirror's centre, at an angle to its normal, with a view so narrow that all rays hit
/// it at nearly that angle.
Camera narrow_at(double degrees, double fov_y_deg) {
  const double a = glm::radians(degrees);
  return look_at({0.0, 4.0 * std::cos(a), 4.0 * std::sin(a)}, {0, 0, 0}, fov_y_deg);
}

/// A dark half-plane to the left of x = 0 above the mirror, as far as is visible. Rays resolve its
/// edge to 2^-24 of `far`.
Face dark_half(double height, double far = 1 << 20) {
  return {{{-far, height, far}, {0, height, far}, {0, height, -far}, {-far, height, -far}}, 0.0f};
}

/// Adds plane mirrors: a card's image, and grazing views.
void add_plane(std::vector<Case>& cases) {
  cases.push_back(
      {"a card in a mirror", mirror_group, true, [] {
         // The card is behind the camera, which sees its image in the mirror.
         Face card = tilted_card();
         for (glm::dvec3& p : card.corners) p.z += 6.0;
         Face image = card;
         for (glm::dvec3& p : image.corners) p.z = -p.z;
         const PictureView view{look_at({0, 0, 4}, {0, 0, 0}, 20.0), picture_side, picture_side};
         Scene scene = scene_of({card}, view.camera);
         place(scene, mesh_of({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}), mirror());
         add_dark_light(scene);
         return worst_pixel({"radiance of the worst of 16x16 pixels",
                             rounding_bound(view, {6.0, 10.0, 2, 0.65, 32.0}),
                             std::string(rounding_reason) + "; and as many of the mirrored ray"},
                            render(scene, settings_of(picture_side, picture_side)),
                            [&](int x, int y) { return faces_radiance(view, {image}, x, y); });
       }});
  for (const double degrees : {89.0, 89.99, 89.9999, 90.0}) {
    cases.push_back(
        {fmt::format("a mirror seen at {} degrees", degrees), mirror_group, true, [degrees] {
           const double a = glm::radians(degrees);
           const double up = degrees == 90.0 ? 0.0 : 4.0 * std::cos(a);
           const Camera camera = look_at({0, up, 4.0 * std::sin(a)}, {0, 0, 0}, 30.0);
           return worst_pixel(
               all_of_the_sky,
               render(floor_mirror(mirror(), camera), settings_of(small_side, small_side)),
               [](int, int) { return background; });
         }});
  }
  cases.push_back(
      {"a mirror seen at 89.9999 degrees that blurs", mirror_group, true, [] {
         const double a = glm::radians(89.9999);
         const Camera camera = look_at({0, 4.0 * std::cos(a), 4.0 * std::sin(a)}, {0, 0, 0}, 30.0);
         return worst_pixel(all_of_the_sky,
                            render(floor_mirror(mirror({0.05, 1.0, 32.0}), camera),
                                   settings_of(small_side, small_side)),
                            [](int, int) { return background; });
       }});
}

/// Renders one pixel of a mirror under a half-plane whose edge is above the mirror's centre.
Result<Outcome> half_dark(const DfrCurve& curve, double bound, const std::string& why) {
  Scene scene = floor_mirror(mirror(curve), narrow_at(0.0, 1.0));
  add(scene, curve.min < 1.0 ? dark_half(6.0) : dark_half(6.0, 1024.0));
  return one_value({"radiance of the pixel", bound, why}, 0.5 * background,
                   render(scene, settings_of(1, 1)), [](const Picture& p) { return p.at(0, 0); });
}

constexpr double blur_view_deg = 0.01;

/// Compares two curves that should give the same reflection at the angle of a view.
Case same_blur(const std::string& name, double degrees, const DfrCurve& curve,
               const DfrCurve& other, const Measure& measure) {
  return {name, mirror_group, true, [=] {
            const auto picture = [&](const DfrCurve& c) {
              Scene scene = floor_mirror(mirror(c), narrow_at(degrees, blur_view_deg));
              add(scene, dark_half(6.0));
              return render(scene, settings_of(small_side, small_side));
            };
            return worst_difference(measure, picture(other), picture(curve));
          }};
}

void add_ratios(std::vector<Case>& cases) {
  const std::string symmetric =
      "the dark half and the bright one are mirror images of each other: half of the sky; the "
      "profile of an edge is held to 1e-3";
  for (const double dfr : {0.0, 1e-300, 0.05, 1.0}) {
    cases.push_back({fmt::format("an edge over a mirror of DFR {:g}", dfr), mirror_group, true,
                     [dfr, symmetric] {
                       return half_dark({dfr, dfr, 1.0}, 1e-3 * background, symmetric);
                     }});
  }
  cases.push_back({"an even sky in a mirror of DFR 0", mirror_group, true, [] {
                     const Camera camera = look_at({0, 3, 4}, {0, 0, 0}, 50.0);
                     return worst_pixel(all_of_the_sky,
                                        render(floor_mirror(mirror({0.0, 0.0, 1.0}), camera),
                                               settings_of(small_side, small_side)),
                                        [](int, int) { return background; });
                   }});
  const Measure bits{"radiance of the pixel that differs most", 0.0,
                     "the same ratio by two curves: no bit may differ"};
  cases.push_back(
      same_blur("N 0 is DFRMAX everywhere", 40.0, {0.1, 0.5, 0.0}, {0.5, 0.5, 1.0}, bits));
  cases.push_back(
      same_blur("N 1e4 at 60 degrees is DFRMIN", 60.0, {0.3, 1.0, 1e4}, {0.3, 0.3, 1.0}, bits));
  cases.push_back(same_blur("DFRMIN above DFRMAX, seen from above", 0.0, {1.0, 0.2, 1.0},
                            {1.0, 1.0, 1.0},
                            {"radiance of the pixel that differs most", 1e-3,
                             "within 1e-4 radians of the normal the ratio is within 1e-4 of 1"}));
  const double between = 1.0 - 0.8 * std::sin(glm::radians(60.0));
  cases.push_back(same_blur("DFRMIN above DFRMAX at 60 degrees", 60.0, {1.0, 0.2, 1.0},
                            {between, between, 1.0},
                            {"radiance of the pixel that differs most", 1e-3,
                             "within 1e-4 radians of the angle the ratio is within 1e-4"}));
  for (const double alpha : {0.0, 30.0, 89.9999, 90.0}) {
    cases.push_back({fmt::format("N 1e4 at {} degrees", alpha), mirror_group, true, [alpha] {
                       const double a = glm::radians(alpha);
                       return plain_value({"defocusing ratio from 0.05 to 1", 1e-12,
                                           "its closed form; 1e4 roundings of doubles"},
                                          0.05 + 0.95 * std::pow(std::sin(a), 1e4),
                                          dfr_at(DfrCurve{0.05, 1.0, 1e4}, std::cos(a)));
                     }});
  }
}

/// Two mirrors that face each other, 2 apart, seen from between them.
Scene facing(float reflected, double half) {
  const Camera camera = look_at({0, 0, 0.5}, {0.01, 0.005, -1}, 0.5);
  Scene scene = scene_of({}, camera);
  Material material = mirror();
  material.base_color = glm::vec4(glm::vec3(reflected), 1.0f);
  for (const double z : {-1.0, 1.0})
    place(scene, mesh_of({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}),
          material);
  add_dark_light(scene);
  return scene;
}

void add_bounces(std::vector<Case>& cases) {
  RenderSettings deepest = settings_of(small_side, small_side);
  deepest.mirror.bounces = MirrorSettings::max_bounces;
  cases.push_back({"facing mirrors, 64 bounces, nothing lost", mirror_group, true, [deepest] {
                     return worst_pixel(
                         {worst_of_small, 65.0 * 8.0 * rounding,
                          "white metal loses nothing: what is not followed any more is the sky, "
                          "0.35; eight roundings a bounce"},
                         render(facing(1.0f, 64.0), deepest), [](int, int) { return unfollowed; });
                   }});
  cases.push_back(
      {"facing mirrors, 64 bounces, a tenth lost at each", mirror_group, true, [deepest] {
         // 53 is the smallest n with 0.9^n < 1/256.
         const double left = std::pow(static_cast<double>(0.9f), 53.0);
         return worst_pixel({worst_of_small, unfollowed * left * 54.0 * 8.0 * rounding,
                             "what has less than 1/256 of a pixel's light is not followed, but is "
                             "the sky; eight roundings a bounce"},
                            render(facing(0.9f, 64.0), deepest),
                            [left](int, int) { return unfollowed * left; });
       }});
  cases.push_back({"rays are spared where nothing is left", mirror_group, true, [deepest] {
                     return one_value({"mirrored rays a pixel", 1.0,
                                       "0.5^8 is 1/256: a pixel's ray is mirrored 8 times, and "
                                       "once more or less by rounding"},
                                      8.0, render(facing(0.5f, 64.0), deepest),
                                      [](const Picture& p) {
                                        return static_cast<double>(p.statistics.reflection_rays) /
                                               (small_side * small_side);
                                      });
                   }});
  cases.push_back({"a mirror without bounces shows the sky", mirror_group, true, [] {
                     RenderSettings settings = settings_of(small_side, small_side);
                     settings.mirror.bounces = 0;
                     const Camera camera = look_at({0, 3, 4}, {0, 0, 0}, 50.0);
                     return worst_pixel(
                         {worst_of_small, 64.0 * rounding, "all of the sky, as where bounces end"},
                         render(floor_mirror(mirror(), camera), settings),
                         [](int, int) { return unfollowed; });
                   }});
}

/// A dish: the paraboloid whose focus is at (0, 1, 0), open to +Y.
Scene dish(const Camera& camera) {
  constexpr int rings = 64;
  constexpr int spokes = 64;
  constexpr double widest = 1.0;
  Mesh mesh;
  for (int j = 0; j <= rings; ++j) {
    const double r = widest * j / rings;
    for (int i = 0; i < spokes; ++i) {
      const double a = 2.0 * std::numbers::pi * (i + 0.5) / spokes;
      const glm::dvec3 p(r * std::cos(a), 0.25 * r * r, r * std::sin(a));
      mesh.positions.emplace_back(p);
      mesh.normals.emplace_back(glm::normalize(glm::dvec3(-0.5 * p.x, 1.0, -0.5 * p.z)));
    }
  }
  for (std::uint32_t j = 0; j < rings; ++j) {
    for (std::uint32_t i = 0; i < spokes; ++i) {
      const std::uint32_t a = j * spokes + i, b = j * spokes + (i + 1) % spokes;
      if (j > 0) mesh.triangles.emplace_back(a, b, b + spokes);
      mesh.triangles.emplace_back(a, b + spokes, a + spokes);
    }
  }
  Scene scene = scene_of({}, camera);
  place(scene, std::move(mesh), mirror());
  add_dark_light(scene);
  return scene;
}

void add_curved(std::vector<Case>& cases) {
  for (const auto& [name, kind] : {std::pair{"approximate", CurvedMirror::approximate},
                                   {"tangent", CurvedMirror::tangent},
                                   {"adaptive", CurvedMirror::adaptive}}) {
    cases.push_back(
        {fmt::format("a dish seen from its focus, {}", name), mirror_group, true, [kind = kind] {
           // Rays from the focus are parallel after reflection: half of them hit the dark half.
           Scene scene = dish(look_at({0, 1, 0}, {0, 0, 0}, 30.0));
           add(scene, dark_half(1e4));
           RenderSettings settings = settings_of(picture_side, picture_side);
           settings.mirror.curved = kind;
           return one_value(
               {"mean radiance of 16x16 pixels", background / 256.0,
                "the dish is symmetrical: half of it mirrors the dark half; the pixels "
                "beside the middle may be a step of 1/256 off in all"},
               0.5 * background, render(scene, settings), [](const Picture& p) {
                 double sum = 0.0;
                 for (const glm::vec3& c : p.film.radiance) sum += static_cast<double>(c.x);
                 return sum / static_cast<double>(p.film.radiance.size());
               });
         }});
    cases.push_back({fmt::format("a dish in an even sky, seen from its focus, {}", name),
                     mirror_group, true, [kind = kind] {
                       RenderSettings settings = settings_of(small_side, small_side);
                       settings.mirror.curved = kind;
                       return worst_pixel(
                           all_of_the_sky,
                           render(dish(look_at({0, 1, 0}, {0, 0, 0}, 30.0)), settings),
                           [](int, int) { return background; });
                     }});
  }
  for (const auto& [name, z] : {std::pair{"focus", 0.5}, {"centre", 0.0}, {"skin", 1.0 - 1e-4}}) {
    cases.push_back(
        {fmt::format("inside a mirroring ball, at its {}", name), mirror_group, true, [z = z] {
           Scene scene = scene_of({}, look_at({0, 0, z}, {0.1, 0.2, -2.0}, 50.0));
           Material skin = mirror();
           skin.double_sided = true;
           add_shape(scene, ball_shape(1.0), skin);
           add_dark_light(scene);
           return worst_pixel({worst_of_small, 64.0 * rounding,
                               "nothing leaves the ball: what four bounces end in is "
                               "the sky, 0.35"},
                              render(scene, settings_of(small_side, small_side)),
                              [](int, int) { return unfollowed; });
         }});
  }
}

void add_mirror_scales(std::vector<Case>& cases) {
  const Measure bits{"radiance of the pixel that differs most", 0.0,
                     "a power of two changes no float's digits, so that no bit may differ"};
  for (const int power : {-20, 20}) {
    cases.push_back(
        {fmt::format("a blurred mirror scaled by 2^{}", power), mirror_group, true, [power, bits] {
           Scene scene =
               floor_mirror(mirror({0.3, 0.3, 1.0}), look_at({0, 2, 4}, {0, 0, 0}, 40.0), 16.0);
           add(scene, {{{-1, 0.25, -1}, {1, 0.25, -1}, {1, 2, -1}, {-1, 2, -1}}, 1.0f});
           const double scale = std::ldexp(1.0, power);
           const glm::dmat4 scaled = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
           const RenderSettings settings = settings_of(small_side, small_side);
           return worst_difference(bits, render(scene, settings),
                                   render(transformed(scene, scaled, scale), settings));
         }});
  }
}

}  // namespace

std::vector<Case> mirror_cases() {
  std::vector<Case> cases;
  add_plane(cases);
  add_ratios(cases);
  add_bounces(cases);
  add_curved(cases);
  add_mirror_scales(cases);
  return cases;
}

}  // namespace asos::stability
