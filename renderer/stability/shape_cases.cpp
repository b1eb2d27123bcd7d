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

// Analytic shapes of extreme sizes and proportions, from near, far and inside.

namespace asos::stability {
namespace {

constexpr const char* shape_group = "shapes";

/// Returns the area, in pixels, that white shapes cover in a picture with the sky as background.
double covered_pixels(const Picture& picture) {
  double sum = 0.0;
  for (const glm::vec3& c : picture.film.radiance)
    sum += (static_cast<double>(c.x) - background) / (1.0 - background);
  return sum;
}

/// Compares a shape's area with the closed form, in pixels. The picture has 16 x 16 pixels by
/// parallel rays along -Z and is `height` high. Outlines cross some 60 pixels.
Result<Outcome> area_case(const Shape& shape, const glm::dmat4& placed, double height, double area,
                          double bound) {
  Scene scene = scene_of({}, parallel({0.013 * height, -0.007 * height, 4.0 * height},
                                      {0.013 * height, -0.007 * height, 0.0}, height));
  add_shape(scene, shape, unlit(1.0f), placed);
  const double pixels = std::pow(picture_side / height, 2.0);
  return one_value({"pixels of 256 that it covers", bound,
                    "its outline is exact: 1e-5 of each of some 60 pixels that it crosses"},
                   area * pixels, render(scene, settings_of(picture_side, picture_side)),
                   covered_pixels);
}

constexpr double outline_bound = 60.0 * 1e-5;

glm::dmat4 stretched(double x, double y, double z) {
  return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

void add_shape_sizes(std::vector<Case>& cases) {
  using std::numbers::pi;
  for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const auto named = [&](const char* what) { return fmt::format("{} of size {:g}", what, size); };
    cases.push_back({named("a ball"), shape_group, true, [size] {
                       return area_case(ball_shape(size), glm::dmat4(1.0), 3.0 * size,
                                        pi * size * size, outline_bound);
                     }});
    cases.push_back({named("a cylinder on its side"), shape_group, true, [size] {
                       return area_case(cylinder_shape(2.0 * size, 0.5 * size, 0.5 * size),
                                        glm::dmat4(1.0), 3.0 * size, 2.0 * size * size,
                                        outline_bound);
                     }});
    cases.push_back({named("a cone"), shape_group, true, [size] {
                       return area_case(cylinder_shape(2.0 * size, 0.75 * size, 0.0),
                                        glm::dmat4(1.0), 3.0 * size, 1.5 * size * size,
                                        outline_bound);
                     }});
    cases.push_back({named("a disk"), shape_group, true, [size] {
                       Shape disk = ball_shape(size);
                       disk.type = Shape::Type::disk;
                       return area_case(disk,
                                        glm::rotate(glm::dmat4(1.0), 0.5 * pi, glm::dvec3(1, 0, 0)),
                                        3.0 * size, pi * size * size, outline_bound);
                     }});
  }
}

void add_proportions(std::vector<Case>& cases) {
  using std::numbers::pi;
  cases.push_back({"a ball squeezed to 1e-3, on edge", shape_group, true, [] {
                     return area_case(ball_shape(1.0), stretched(1.0, 1e-3, 1.0), 3.0, pi * 1e-3,
                                      outline_bound);
                   }});
  cases.push_back({"a cylinder of radius 1e-3", shape_group, true, [] {
                     return area_case(cylinder_shape(2.0, 1e-3, 1e-3), glm::dmat4(1.0), 3.0,
                                      4.0 * 1e-3, outline_bound);
                   }});
  // From a distance, these shapes would cover less than an outline's error. They cross the whole
  // picture.
  cases.push_back({"a ball squeezed to a needle of 1e-6, from close by", shape_group, true, [] {
                     return area_case(ball_shape(1.0), stretched(1.0, 1e-6, 1e-6), 3e-6,
                                      2e-6 * 3e-6, outline_bound);
                   }});
  cases.push_back({"a cylinder of radius 1e-6, from close by", shape_group, true, [] {
                     return area_case(cylinder_shape(2.0, 1e-6, 1e-6), glm::dmat4(1.0), 3e-6,
                                      2e-6 * 3e-6, outline_bound);
                   }});
  for (const double thin : {1e-3, 1e-6}) {
    cases.push_back(
        {fmt::format("a truncated cone of radii 1 and {:g}", thin), shape_group, true, [thin] {
           return area_case(cylinder_shape(2.0, 1.0, thin), glm::dmat4(1.0), 3.0,
                            2.0 * (1.0 + thin), outline_bound);
         }});
  }
  cases.push_back({"a ball mirrored by its node", shape_group, true, [] {
                     return area_case(ball_shape(1.0), stretched(-1.0, 1.0, 1.0), 3.0, pi,
                                      outline_bound);
                   }});
  cases.push_back({"a ball sheared into an ellipsoid", shape_group, true, [] {
                     glm::dmat4 sheared(1.0);
                     sheared[1].x = 0.5;  // x + y / 2 keeps areas seen along Z
                     return area_case(ball_shape(0.9), sheared, 3.0, 0.81 * pi, outline_bound);
                   }});
  cases.push_back({"a ball of 1e-6 beside one of 1e3", shape_group, true, [] {
                     Scene scene = scene_of({}, parallel({0, 0, 4e-6}, {0, 0, 0}, 3e-6));
                     add_shape(scene, ball_shape(1e-6), unlit(1.0f));
                     add_shape(scene, ball_shape(1e3), unlit(1.0f),
                               glm::translate(glm::dmat4(1.0), glm::dvec3(2000.0, 0, 0)));
                     return one_value({"pixels of 256 that it covers", 0.01,
                                       "a ball's place is a double relative to its own middle; "
                                       "rays are floats, 6e-8 of their distance"},
                                      pi * std::pow(picture_side / 3.0, 2.0),
                                      render(scene, settings_of(picture_side, picture_side)),
                                      covered_pixels);
                   }});
}

void add_shape_places(std::vector<Case>& cases) {
  for (const double radius : {1.0, 1e3, 1e6}) {
    cases.push_back({fmt::format("1e-4 radii from the skin of a ball of {:g}", radius), shape_group,
                     true, [radius] {
                       Scene scene = scene_of({}, look_at({0, 0, radius * 1.0001}, {0, 0, 0}, 50));
                       add_shape(scene, ball_shape(radius), unlit(1.0f));
                       return worst_pixel({"radiance of the worst of 8x8 pixels", 8.0 * rounding,
                                           "it fills the view: no outline is seen"},
                                          render(scene, settings_of(small_side, small_side)),
                                          [](int, int) { return 1.0; });
                     }});
    cases.push_back(
        {fmt::format("inside a ball of {:g}", radius), shape_group, true, [radius] {
           Scene scene = scene_of({}, look_at({0, 0, 0.3 * radius}, {0.2 * radius, 0, 0}, 120));
           add_shape(scene, ball_shape(radius), unlit(1.0f));
           return worst_pixel({"radiance of the worst of 8x8 pixels", 8.0 * rounding,
                               "it surrounds the view: no outline is seen"},
                              render(scene, settings_of(small_side, small_side)),
                              [](int, int) { return 1.0; });
         }});
  }
  for (const double distance : {30.0, 1e3, 1e7}) {
    cases.push_back(
        {fmt::format("a ball in one pixel, seen from {:g}", distance), shape_group, true,
         [distance] {
           const Camera camera = look_at({0, 0, distance}, {0, 0, 0}, 50.0);
           Scene scene = scene_of({}, camera);
           add_shape(scene, ball_shape(1.0), unlit(1.0f));
           // The tangent of the half angle of a ball is r / sqrt(d^2 - r^2).
           const double pixels = 1.0 / (2.0 * std::tan(0.5 * camera.fov_y_rad));
           const double share = std::numbers::pi * pixels * pixels / (distance * distance - 1.0);
           return one_value(
               {"radiance of the pixel", 1e-5, "outlines of shapes are exact to 1e-5 of a pixel"},
               background + share * (1.0 - background), render(scene, settings_of(1, 1)),
               [](const Picture& p) { return p.at(0, 0); });
         }});
  }
}

void add_shape_refusals(std::vector<Case>& cases) {
  for (const auto& [name, shape] :
       {std::pair{"a ball of radius 0", ball_shape(0.0)},
        {"a ball of infinite radius", ball_shape(1e308 * 10)},
        {"a cylinder of two radii 0", cylinder_shape(1.0, 0.0, 0.0)},
        {"a cylinder whose height is not a number", cylinder_shape(std::nan(""), 1.0, 1.0)}}) {
    cases.push_back({fmt::format("{} is refused", name), shape_group, true,
                     [shape = shape]() -> Result<Outcome> {
                       Scene scene = scene_of({}, card_camera());
                       add_shape(scene, shape, unlit(1.0f));
                       return plain_value({"refused (1: yes)", 0.0, "yes or no"}, 1.0,
                                          render(scene, settings_of(1, 1)) ? 0.0 : 1.0);
                     }});
  }
  cases.push_back({"a ball that its node squeezes flat", shape_group, true, [] {
                     Scene scene = scene_of({}, card_camera());
                     add_shape(scene, ball_shape(1.0), unlit(1.0f), stretched(1.0, 1.0, 0.0));
                     return one_value(
                         {"pixels of 256 that it covers, relative to its disk", 0.01,
                          "it has no inverse and is drawn as a mesh of some thousand triangles, "
                          "whose outline of 64 sides has 0.2 % less area"},
                         1.0, render(scene, settings_of(picture_side, picture_side)),
                         [](const Picture& p) {
                           const PictureView view{card_camera(), picture_side, picture_side};
                           const double radius = view.pixels_per_unit() / 4.0;
                           return covered_pixels(p) / (std::numbers::pi * radius * radius);
                         });
                   }});
}

}  // namespace

std::vector<Case> shape_cases() {
  std::vector<Case> cases;
  add_shape_sizes(cases);
  add_proportions(cases);
  add_shape_places(cases);
  add_shape_refusals(cases);
  return cases;
}

}  // namespace asos::stability
