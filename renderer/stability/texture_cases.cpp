#include "renderer/scene/make_light.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Textures of extreme sizes, and coordinates and transforms that define no single texel.

namespace asos::stability {
namespace {

constexpr const char* texture_group = "textures";

/// Greys in a row.
Image row(const std::vector<std::uint8_t>& greys) {
  Image image;
  image.width = static_cast<int>(greys.size());
  image.height = 1;
  for (const std::uint8_t grey : greys)
    image.rgba.own().insert(image.rgba.own().end(), {grey, grey, grey, 255});
  return image;
}

Image black_and_white(int width) {
  std::vector<std::uint8_t> greys(static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < greys.size(); ++i) greys[i] = i % 2 ? 255 : 0;
  return row(greys);
}

/// A square of two units that fills the picture, with coordinates from `from` to `from` + `span`.
struct Textured {
  Image image;
  glm::vec2 from{0.0f};
  glm::vec2 span{1.0f};
  glm::mat3 transform{1.0f};
  Filter filter = Filter::linear;

  [[nodiscard]] Scene scene() const {
    Scene scene = scene_of({}, parallel({0, 0, 1}, {0, 0, 0}, 2.0));
    scene.images.push_back(image);
    Texture texture;
    texture.image = 0;
    texture.filter = filter;
    scene.textures.push_back(texture);
    Material material = unlit(1.0f);
    material.base_color_texture.texture = 0;
    material.base_color_texture.uv_transform = transform;
    Mesh mesh = mesh_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    for (const glm::vec2 corner :
         {glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0), glm::vec2(0, 0)})
      mesh.texcoords[0].push_back(from + span * corner);
    place(scene, std::move(mesh), material);
    return scene;
  }
};

/// Compares a whole picture with one radiance.
Case level(const std::string& name, const Textured& textured, double expected,
           const Measure& measure) {
  return {name, texture_group, true, [=] {
            return worst_pixel(measure,
                               render(textured.scene(), settings_of(small_side, small_side)),
                               [expected](int, int) { return expected; });
          }};
}

constexpr const char* worst = "radiance of the worst of 8x8 pixels";
const Measure exact{worst, 8.0 * rounding, "one texel's float, 8 roundings"};
const Measure averaged{worst, 1.0 / 65536.0, "means are kept to 16 bits"};
// The sRGB curve of IEC 61966-2-1 at 188.
const double grey_188 = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
const Measure any_mean{worst, averaged.bound,
                       "coordinates that float32 cannot tell apart stand for all of the texture: "
                       "its mean, kept to 16 bits"};
const double middle_grey = 0.5 * (grey_188 + 1.0);

void add_texture_sizes(std::vector<Case>& cases) {
  cases.push_back(level("a texture of 1x1", {row({188})}, grey_188, exact));
  cases.push_back(level("a texture of 1x1, seen 1e6 times over",
                        {row({188}), glm::vec2(0.0f), glm::vec2(1e6f)}, grey_188, exact));
  cases.push_back(level("a texture 16384 wide, black and white in turn", {black_and_white(16384)},
                        0.5, averaged));
  cases.push_back(level("the same through 1e4 repeats",
                        {black_and_white(16384), glm::vec2(0.0f), glm::vec2(1e4f)}, 0.5, averaged));
  cases.push_back(
      {"a texture 16384 wide, sampled at points", texture_group, true, [] {
         RenderSettings settings = settings_of(small_side, small_side);
         settings.texture.filter = TextureFilter::point;
         std::vector<std::uint8_t> greys(16384, 255);
         for (std::size_t i = 0; i < greys.size(); i += 2) greys[i] = 188;
         return worst_pixel(
             {worst, 8.0 * rounding * 16384.0 * (1.0 - grey_188),
              "pixels' middles lie between two texels, off by 8 roundings of the coordinate, 16384 "
              "texels wide"},
             render(Textured{row(greys)}.scene(), settings), [](int, int) { return middle_grey; });
       }});
  cases.push_back(level("an image without texels is white", {Image{}}, 1.0, exact));
}

void add_resolutions(std::vector<Case>& cases) {
  for (const int tr : {1, 8}) {
    RenderSettings settings = settings_of(small_side, small_side);
    settings.texture.resolution = tr;
    cases.push_back({fmt::format("TR {} on one grey", tr), texture_group, true, [settings] {
                       return worst_pixel(
                           {worst, 16.0 * rounding, "one texel's float, and the sum of samples"},
                           render(Textured{row({188, 188})}.scene(), settings),
                           [](int, int) { return grey_188; });
                     }});
    cases.push_back({fmt::format("TR {} on a texture 16384 wide, averaged", tr), texture_group,
                     true, [settings] {
                       return worst_pixel(
                           averaged, render(Textured{black_and_white(16384)}.scene(), settings),
                           [](int, int) { return 0.5; });
                     }});
  }
  cases.push_back({"TR 8 on a texture 16384 wide, at points", texture_group, true, [] {
                     RenderSettings settings = settings_of(small_side, small_side);
                     settings.texture.resolution = 8;
                     settings.texture.filter = TextureFilter::point;
                     constexpr int samples = 64 * small_side * small_side;
                     return one_value(
                         {"mean radiance of 8x8 pixels", 4.0 * std::sqrt(0.25 / samples),
                          "4096 samples at random, whose deviation is at most 1/2: four deviations "
                          "of their mean"},
                         0.5, render(Textured{black_and_white(16384)}.scene(), settings),
                         [](const Picture& p) {
                           double sum = 0.0;
                           for (int y = 0; y < small_side; ++y)
                             for (int x = 0; x < small_side; ++x) sum += p.at(x, y);
                           return sum / (small_side * small_side);
                         });
                   }});
  cases.push_back(
      {"TR 8 takes 64 samples of a pixel", texture_group, true, [] {
         RenderSettings settings = settings_of(small_side, small_side);
         settings.texture.resolution = 8;
         return one_value(
             {"eye rays a pixel", 8.0,
              "8 x 8 samples, the one that found the texture, and up to eight that look beyond its "
              "triangle"},
             65.0, render(Textured{row({188, 255})}.scene(), settings), [](const Picture& p) {
               return static_cast<double>(p.statistics.eye_rays) / (small_side * small_side);
             });
       }});
}

void add_coordinates(std::vector<Case>& cases) {
  const Image two = row({188, 255});
  cases.push_back(level("coordinates of 1e8", {two, glm::vec2(1e8f)}, middle_grey, any_mean));
  cases.push_back(level("coordinates from -1e30 to 1e30",
                        {two, glm::vec2(-1e30f), glm::vec2(2e30f)}, middle_grey, any_mean));
  cases.push_back(
      level("coordinates of 1e8 on one grey", {row({188, 188}), glm::vec2(1e8f)}, grey_188, exact));
  cases.push_back(level("coordinates that are not numbers",
                        {two, glm::vec2(std::numeric_limits<float>::quiet_NaN())}, middle_grey,
                        any_mean));
  cases.push_back(
      level("coordinates that are infinite", {two, glm::vec2(infinite)}, middle_grey, any_mean));
  cases.push_back({"coordinates moved by 1024 repeats", texture_group, true, [] {
                     // A ramp that returns to its start; 8 texels per pixel.
                     std::vector<std::uint8_t> ramp;
                     for (int i = 0; i < 64; ++i)
                       ramp.push_back(static_cast<std::uint8_t>(i < 32 ? 8 * i : 8 * (63 - i)));
                     Textured at_zero{row(ramp)};
                     Textured moved = at_zero;
                     moved.from = glm::vec2(1024.0f, 0.0f);
                     // A byte's step is at most 2.4 / 1.055 * 8 / 255 of radiance per texel.
                     const double bound = 8.0 * rounding * 1024.0 * 64.0 * 0.0714;
                     return worst_difference(
                         {"radiance of the pixel that differs most", bound + 2.0 / 65536.0,
                          "8 roundings of coordinates of 1024, 64 texels a repeat, each step of at "
                          "most 0.0714; and means of 16 bits"},
                         render(at_zero.scene(), settings_of(small_side, small_side)),
                         render(moved.scene(), settings_of(small_side, small_side)));
                   }});
}

void add_transforms(std::vector<Case>& cases) {
  const Image two = row({188, 255});
  // The whole picture shows one point: the centre of the white texel.
  glm::mat3 to_white(0.0f);
  to_white[2] = glm::vec3(0.75f, 0.5f, 1.0f);
  cases.push_back(level("a transform that squeezes all to one point",
                        {two, glm::vec2(0.0f), glm::vec2(1.0f), to_white}, 1.0, exact));
  glm::mat3 nan(std::numeric_limits<float>::quiet_NaN());
  cases.push_back(level("a transform that is not a number",
                        {two, glm::vec2(0.0f), glm::vec2(1.0f), nan}, middle_grey, any_mean));
  glm::mat3 huge(1e30f);
  cases.push_back(level("a transform by 1e30", {two, glm::vec2(0.0f), glm::vec2(1.0f), huge},
                        middle_grey, any_mean));
  cases.push_back({"a normal map on coordinates that are all one point", texture_group, true, [] {
                     Textured textured{row({40, 200})};
                     textured.span = glm::vec2(0.0f);
                     Scene scene = textured.scene();
                     scene.materials[0] = matte(0.5f);
                     scene.lights.push_back(make_sun(glm::normalize(glm::dvec3(1, 2, -3))));
                     const auto plain = render(scene, settings_of(small_side, small_side));
                     scene.materials[0].normal_texture.texture = 0;
                     return worst_difference(
                         {"radiance of the pixel that differs most", 8.0 * rounding,
                          "no direction of the map is known, so that the "
                          "surface's own normal stays"},
                         plain, render(scene, settings_of(small_side, small_side)));
                   }});
  cases.push_back({"a normal map that points into the surface", texture_group, true, [] {
                     Scene scene = Textured{row({0, 0})}.scene();
                     scene.materials[0] = matte(0.5f);
                     scene.lights.push_back(make_sun({0, 0, -1}));
                     const auto plain = render(scene, settings_of(small_side, small_side));
                     scene.materials[0].normal_texture.texture = 0;
                     return worst_difference(
                         {"radiance of the pixel that differs most", 8.0 * rounding,
                          "a normal below the surface is not followed"},
                         plain, render(scene, settings_of(small_side, small_side)));
                   }});
}

}  // namespace

std::vector<Case> texture_cases() {
  std::vector<Case> cases;
  add_texture_sizes(cases);
  add_resolutions(cases);
  add_coordinates(cases);
  add_transforms(cases);
  return cases;
}

}  // namespace asos::stability
