#include "renderer/scene/builtin.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Views: grazing angles, fields of view near 0 and 180 degrees, horizons, sizes of the picture.

namespace asos::stability {
namespace {

constexpr const char* view_group = "views";

struct Shot {
  std::vector<Face> faces;
  Camera camera;
  RenderSettings settings;
  RoundingCase rounded;
  std::string reason = rounding_reason;
};

/// Compares faces that do not hide each other with their exact areas in every pixel.
Result<Outcome> shoot(const Shot& shot) {
  const PictureView view{shot.camera, shot.settings.width, shot.settings.height};
  const PixelRect part = shot.settings.visible();
  return worst_pixel({fmt::format("radiance of the worst of {}x{} pixels", part.width, part.height),
                      rounding_bound(view, shot.rounded), shot.reason},
                     render(scene_of(shot.faces, shot.camera), shot.settings), [&](int x, int y) {
                       return faces_radiance(view, shot.faces, part.x + x, part.y + y);
                     });
}

/// A level ground, from `near` behind the camera to `far` in front of it.
Face ground(double near, double far, float colour = 1.0f) {
  return {{{-far, 0, near}, {far, 0, near}, {far, 0, -far}, {-far, 0, -far}}, colour};
}

void add_grazing(std::vector<Case>& cases) {
  for (const double degrees : {89.0, 89.99, 89.9999}) {
    cases.push_back({fmt::format("a card seen at {} degrees from its normal", degrees), view_group,
                     true, [degrees] {
                       const double a = glm::radians(degrees);
                       const glm::dvec3 eye = 4.0 * glm::dvec3(0.0, std::sin(a), std::cos(a));
                       // Zoom in until the card is some pixels high, or until an eighth of a degree
                       // fills one pixel: beyond that, floats do not resolve rays.
                       const double fov = std::max(std::cos(a), 0.02);
                       Shot shot{{tilted_card()},
                                 look_at(eye, {0, 0, 0}, glm::degrees(fov)),
                                 settings_of(8, 8),
                                 {1.5, 2.5, 3, 0.65, 4.0}};
                       shot.reason =
                           "the card's corners are exact in float32 and areas are worked "
                           "out in double: only the colour of a part that is thinner "
                           "than 4 roundings (vertex, eye, two of the ray's direction) "
                           "may be wrong";
                       return shoot(shot);
                     }});
  }
  cases.push_back({"a horizon through the only pixel", view_group, true, [] {
                     return shoot({{ground(10.0, 1e6)},
                                   look_at({0, 1.5, 0}, {0, 1.5, -1}, 50.0),
                                   settings_of(1, 1),
                                   {1e6, 1e6, 2, 0.65}});
                   }});
  cases.push_back(
      {"a horizon tilted through 8x8 pixels", view_group, true, [] {
         Camera camera = look_at({0, 1.5, 0}, {0, 1.2, -1}, 50.0);
         const glm::dvec4 right = camera.world_from_camera[0];
         const glm::dvec4 up = camera.world_from_camera[1];
         camera.world_from_camera[0] = 0.96 * right + 0.28 * up;
         camera.world_from_camera[1] = 0.96 * up - 0.28 * right;
         return shoot({{ground(10.0, 1e6)}, camera, settings_of(8, 8), {1e6, 1e6, 3, 0.65}});
       }});
  cases.push_back({"the camera in the plane of a card", view_group, true, [] {
                     return shoot({{ground(-1.0, 8.0)},
                                   look_at({0, 0, 0}, {0, 0, -1}, 50.0),
                                   settings_of(8, 8),
                                   {8.0, 1.0, 2, 0.65}});
                   }});
}

void add_fields(std::vector<Case>& cases) {
  for (const double fov : {0.001, 0.1, 150.0, 179.0, 179.9}) {
    cases.push_back({fmt::format("a field of view of {} degrees", fov), view_group, true, [fov] {
                       // The card's height is two thirds of the picture's. Rays from a large
                       // distance start within twice the scene's size, so they lose no more digits
                       // than that costs.
                       const double distance = 1.5 / std::tan(0.5 * glm::radians(fov));
                       return shoot({{tilted_card()},
                                     look_at({0, 0, distance}, {0, 0, 0}, fov),
                                     settings_of(16, 16),
                                     {4.5, distance, 2, 0.65}});
                     }});
  }
  cases.push_back({"parallel rays, a picture 1e-6 high", view_group, true, [] {
                     Face card = tilted_card();
                     for (glm::dvec3& p : card.corners) p *= 1.0 / (1 << 21);
                     return shoot({{card},
                                   parallel({0, 0, 1}, {0, 0, 0}, 1.5e-6),
                                   settings_of(16, 16),
                                   {7e-7, 1.0, 2, 0.65}});
                   }});
}

void add_view_sizes(std::vector<Case>& cases) {
  cases.push_back(
      {"a picture of 1x1", view_group, true, [] {
         return shoot({{tilted_card()}, card_camera(), settings_of(1, 1), {1.5, 2.5, 4, 0.65}});
       }});
  cases.push_back({"24x24 of a picture of 16384x16384", view_group, true, [] {
                     RenderSettings settings = settings_of(16384, 16384);
                     // Around the card's rightmost corner.
                     const PictureView view{card_camera(), 16384, 16384};
                     const glm::dvec3 corner = tilted_card().corners[1];
                     const double scale = view.pixels_per_unit() / 4.0;
                     settings.crop = {static_cast<int>(8192.0 + scale * corner.x) - 12,
                                      static_cast<int>(8192.0 - scale * corner.y) - 12, 24, 24};
                     return shoot({{tilted_card()}, view.camera, settings, {1.5, 4.0, 2, 0.65}});
                   }});
  cases.push_back({"a picture of 32768x1, its middle", view_group, true, [] {
                     RenderSettings settings = settings_of(32768, 1);
                     settings.crop = {16376, 0, 16, 1};
                     return shoot({{tilted_card()}, card_camera(), settings, {1.5, 4.0, 4, 0.65}});
                   }});
  cases.push_back({"a crop is that part of the whole", view_group, true, [] {
                     RenderSettings settings = settings_of(24, 16);
                     const Result<Picture> whole = render(still_life(), settings);
                     settings.crop = {5, 3, 11, 9};
                     return worst_pixel({"radiance of the pixel that differs most", 0.0,
                                         "the same work in the same order: no bit may differ"},
                                        render(still_life(), settings), [&](int x, int y) {
                                          return whole ? whole->at(x + 5, y + 3) : NAN;
                                        });
                   }});
}

/// Square cards in a grid within the only pixel; they cover 25/64 of it.
Scene grid_of_cards(int per_side) {
  Scene scene = scene_of({}, parallel({0, 0, 1}, {0, 0, 0}, 1.0));
  const double step = 1.0 / per_side;
  const double half = 0.3125 * step;
  for (int j = 0; j < per_side; ++j) {
    for (int i = 0; i < per_side; ++i) {
      const glm::dvec3 c((i + 0.5) * step - 0.5, (j + 0.5) * step - 0.5, 0.0);
      add(scene, {{c + glm::dvec3(-half, -half, 0), c + glm::dvec3(half, -half, 0),
                   c + glm::dvec3(half, half, 0), c + glm::dvec3(-half, half, 0)},
                  1.0f});
    }
  }
  return scene;
}

constexpr double grid_radiance = background + 25.0 / 64.0 * (1.0 - background);

double only_pixel(const Picture& picture) {
  return picture.at(0, 0);
}

/// Compares a built-in scene, from so far that it lies within one pixel, with point samples.
Result<Outcome> boxes() {
  Result<Scene> scene = builtin_scene("boxes");
  if (!scene) return unexpected(scene.error());
  scene->cameras[0].world_from_camera[3] += 200.0 * scene->cameras[0].world_from_camera[2];
  RenderSettings settings = settings_of(1, 1, 8);
  scene->cameras[0].fov_y_rad = 0.05;
  const auto asos = render(*scene, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 16384;
  const auto points = render(*scene, settings);
  if (!asos) return unexpected(asos.error());
  // The standard deviation of points with a radiance from 0 to 1 is at most 1/2.
  const double deviation = 0.5 * std::sqrt(2.72 / 16384.0);
  return worst_difference(
      {"radiance of the pixel", 4.0 * deviation + asos->statistics.unresolved_area + 1.0 / 2048.0,
       "four deviations of 16384 Sobol points (at most e times the variance of as many random "
       "ones, Owen 1997); the area that the program says stayed unresolved; and 1/2048 of shading"},
      points, asos);
}

void add_tiny(std::vector<Case>& cases) {
  for (const int side : {4, 64}) {
    cases.push_back({fmt::format("a whole scene of {} cards inside one pixel", side * side),
                     view_group, true, [side]() -> Result<Outcome> {
                       const auto picture = render(grid_of_cards(side), settings_of(1, 1, 5));
                       if (!picture) return unexpected(picture.error());
                       return one_value(
                           {"radiance of the pixel",
                            0.65 * picture->statistics.unresolved_area + rounding,
                            "samples in the middle of cells may all meet gaps: the area "
                            "that the program says stayed unresolved, times the contrast; and "
                            "the rounding of the pixel to float32"},
                           grid_radiance, picture, only_pixel);
                     }});
  }
  cases.push_back({"the same with jittered samples", view_group, true, [] {
                     RenderSettings settings = settings_of(1, 1, 5);
                     settings.asos.jitter = true;
                     return one_value(
                         {"radiance of the pixel", 0.65 * 4.0 * std::sqrt(0.25 / 1024.0),
                          "each of the 1024 finest cells of MAX 5 takes one sample at "
                          "random, whose deviation is at most 1/2: four deviations of "
                          "their mean"},
                         grid_radiance, render(grid_of_cards(64), settings), only_pixel);
                   }});
  cases.push_back(
      {"the built-in boxes inside one pixel", view_group, true, [] { return boxes(); }});
  for (const double distance : {1e2, 1e4, 1e5, 1e6}) {
    cases.push_back(
        {fmt::format("a scene that is a speck in its pixel, seen from {:g}", distance), view_group,
         true, [distance] {
           const Camera camera = look_at({0, 0, distance}, {0, 0, 0}, 50.0);
           return shoot({{tilted_card()}, camera, settings_of(1, 1), {1.5, distance, 4, 0.65}});
         }});
  }
}

}  // namespace

std::vector<Case> view_cases() {
  std::vector<Case> cases;
  add_grazing(cases);
  add_fields(cases);
  add_view_sizes(cases);
  add_tiny(cases);
  return cases;
}

}  // namespace asos::stability
