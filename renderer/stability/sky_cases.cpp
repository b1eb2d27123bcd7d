#include "renderer/film/image_io.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Surroundings: too dark, too bright, with one texel, with invalid texels.

namespace asos::stability {
namespace {

constexpr const char* sky_group = "sky";
using SharedSky = std::shared_ptr<const Sky>;
/// Makes a sky when its case runs, since most cases are only listed.
using MakeSky = std::function<SharedSky()>;

SharedSky picture_sky(int height, std::vector<glm::vec3> texels, double turn_deg = 0.0) {
  return std::make_shared<const Sky>(SkyMap(2 * height, height, std::move(texels)), turn_deg, "");
}

MakeSky even_picture(int height, float radiance) {
  return [=] {
    const auto side = static_cast<std::size_t>(height);
    return picture_sky(height, std::vector<glm::vec3>(2 * side * side, glm::vec3(radiance)));
  };
}

/// A dark sky with one bright texel on the horizon, at -Z.
SharedSky spike(float radiance) {
  constexpr int height = 64;
  std::vector<glm::vec3> texels(2 * height * height, glm::vec3(0.0f));
  texels[static_cast<std::size_t>((height / 2) * 2 * height + height)] = glm::vec3(radiance);
  return picture_sky(height, std::move(texels));
}

RenderSettings under_this(const SharedSky& sky) {
  RenderSettings settings = settings_of(small_side, small_side);
  settings.sky = sky;
  return settings;
}

/// Compares a whole picture with one radiance, relative to that radiance.
Case even_sky(const std::string& name, const Scene& scene, const MakeSky& make_sky, double expected,
              double roundings, const char* reason) {
  return {name, sky_group, true, [=] {
            // Relative to the expected value, so that the scale hides no error.
            const double unit = expected > 0.0 ? expected : 1.0;
            return one_value(
                {expected > 0.0 ? "radiance of the worst of 8x8 pixels, relative"
                                : "radiance of the worst of 8x8 pixels",
                 roundings * rounding, reason},
                expected / unit, render(scene, under_this(make_sky())), [=](const Picture& p) {
                  double worst = expected / unit;
                  for (const glm::vec3& c : p.film.radiance) {
                    const double got = static_cast<double>(c.x) / unit;
                    if (!(std::abs(got - expected / unit) <= std::abs(worst - expected / unit)))
                      worst = got;
                  }
                  return worst;
                });
          }};
}

Scene nothing() {
  Scene scene = scene_of({}, look_at({0, 0, 4}, {0, 0.5, 0}, 50.0));
  // A face far behind the camera, since a scene must not be empty.
  add(scene, {{{-1, -1, 99}, {1, -1, 99}, {0, 1, 99}}, 1.0f});
  return scene;
}

Scene wall_of(const Material& material) {
  Scene scene = scene_of({}, look_at({0, 0, 4}, {0, 0, 0}, 50.0));
  place(scene, mesh_of({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}), material);
  add_dark_light(scene);
  return scene;
}

void add_brightness(std::vector<Case>& cases) {
  const double share = static_cast<double>(sky_visibility);
  for (const float radiance : {0.0f, 1e-20f, 1e6f, 1e20f}) {
    const auto sky = [=] { return std::make_shared<const Sky>(glm::vec3(radiance)); };
    const double r = static_cast<double>(radiance);
    const auto named = [&](const char* what) {
      return fmt::format("a sky of {:g}, {}", radiance, what);
    };
    cases.push_back(even_sky(named("seen"), nothing(), sky, r, 8.0, "the sky's own float"));
    cases.push_back(even_sky(named("in a mirror"), wall_of(mirror()), sky, r, 64.0,
                             "white metal returns all of it, but for roundings"));
    if (radiance < 1e-10f && radiance > 0.0f) continue;  // the scene's light outshines such a sky
    cases.push_back(even_sky(named("on a matte wall"), wall_of(matte(0.5f)), sky, 0.5 * share * r,
                             64.0, "0.6 of it times the albedo, 1/2"));
  }
  cases.push_back(even_sky("a picture of one radiance", nothing(), even_picture(16, 0.7f),
                           static_cast<double>(0.7f), 16.0, "means of one float"));
  cases.push_back(even_sky("a picture of 2x1 texels", nothing(), even_picture(1, 0.7f),
                           static_cast<double>(0.7f), 16.0, "means of one float"));
  cases.push_back(even_sky("a picture of 1e30", nothing(), even_picture(16, 1e30f),
                           static_cast<double>(1e30f), 16.0, "means are sums of doubles"));
  cases.push_back(even_sky("a picture of 2048x1024 texels in a mirror", wall_of(mirror()),
                           even_picture(1024, 0.7f), static_cast<double>(0.7f), 64.0,
                           "means of one float, at any size"));
}

void add_contrast(std::vector<Case>& cases) {
  for (const float radiance : {1e4f, 1e10f, 1e30f}) {
    cases.push_back(
        {fmt::format("one texel of {:g} in the dark, on a wall that faces it", radiance), sky_group,
         true, [radiance] {
           // Solid angle of the texel, in row 32 of 64 and one of 128 columns.
           const double texel = 2.0 * std::numbers::pi / 128.0;
           const double height =
               std::cos(std::numbers::pi * 32.0 / 64.0) - std::cos(std::numbers::pi * 33.0 / 64.0);
           const double solid_angle = std::abs(height) * texel;
           const double lux = static_cast<double>(radiance) * solid_angle;
           Scene scene = wall_of(matte(1.0f));
           // The texel is at -Z, half a texel off, and the wall is seen from behind.
           scene.cameras[0] = look_at({0, 0, -4}, {0, 0, 0}, 50.0);
           const double expected = static_cast<double>(sky_visibility) * lux / std::numbers::pi;
           return one_value({"radiance of the worst of 8x8 pixels, relative", 0.01,
                             "irradiance is found from texels of some 3 degrees and kept for "
                             "normals 6 degrees apart; the cosine there is within 1 % of 1"},
                            1.0, render(scene, under_this(spike(radiance))), [=](const Picture& p) {
                              double worst = 1.0;
                              for (const glm::vec3& c : p.film.radiance) {
                                const double got = static_cast<double>(c.x) / expected;
                                if (!(std::abs(got - 1.0) <= std::abs(worst - 1.0))) worst = got;
                              }
                              return worst;
                            });
         }});
    cases.push_back(
        {fmt::format("one texel of {:g} in the dark, seen", radiance), sky_group, true, [radiance] {
           return one_value({"pixels of 64 from 0 to its radiance", 0.0,
                             "a mean is neither below nor above all that it is of"},
                            64.0, render(nothing(), under_this(spike(radiance))),
                            [radiance](const Picture& p) {
                              return static_cast<double>(std::count_if(
                                  p.film.radiance.begin(), p.film.radiance.end(),
                                  [=](glm::vec3 c) { return c.x >= 0.0f && c.x <= radiance; }));
                            });
         }});
  }
  cases.push_back({"a sky turned by 360 degrees", sky_group, true, [] {
                     std::vector<glm::vec3> texels;
                     for (int i = 0; i < 32 * 16; ++i)
                       texels.emplace_back(0.5f + 0.4f * std::sin(0.7f * static_cast<float>(i)));
                     return worst_difference(
                         {"radiance of the pixel that differs most", 1e-6,
                          "a turn's sine is 2e-16 off; texels differ by at most 0.8"},
                         render(nothing(), under_this(picture_sky(16, texels))),
                         render(nothing(), under_this(picture_sky(16, texels, 360.0))));
                   }});
  cases.push_back({"a gradient from 0 to 1e10", sky_group, true, [] {
                     const auto sky =
                         std::make_shared<const Sky>(glm::vec3(1e10f), glm::vec3(0.0f));
                     Scene scene = nothing();
                     scene.cameras[0] = look_at({0, 0, 0}, {0, 1, 0}, 0.01);
                     return one_value({"radiance of the zenith, relative", 1e-6,
                                       "linear in the sine of the elevation, 1 at the zenith"},
                                      1.0, render(scene, under_this(sky)), [](const Picture& p) {
                                        return p.at(small_side / 2, small_side / 2) / 1e10;
                                      });
                   }});
}

/// A sky picture with one invalid texel, as a file: it must be rejected, not displayed as black or
/// NaN.
Case refused_texel(const std::string& name, float odd) {
  return {name, sky_group, true, [odd]() -> Result<Outcome> {
            namespace fs = std::filesystem;
            std::string folder = (fs::temp_directory_path() / "asos-sky-XXXXXX").string();
            if (!mkdtemp(folder.data())) return unexpected(Error{folder, "cannot be made"});
            Film film(8, 4);
            film.radiance[13].y = odd;
            const std::string path = (fs::path(folder) / "sky.exr").string();
            const auto written = write_exr(path, film, {});
            const auto sky = read_sky(path);
            fs::remove_all(folder);
            if (!written) return unexpected(written.error());
            const bool named = !sky && sky.error().subject == path;
            return plain_value({"refused, naming the file (1: yes)", 0.0, "yes or no"}, 1.0,
                               named ? 1.0 : 0.0);
          }};
}

}  // namespace

std::vector<Case> sky_cases() {
  std::vector<Case> cases;
  add_brightness(cases);
  add_contrast(cases);
  cases.push_back(refused_texel("an HDR sky with a texel that is not a number", not_a_number));
  cases.push_back(refused_texel("an HDR sky with an infinite texel", infinite));
  cases.push_back(refused_texel("an HDR sky with a negative texel", -1.0f));
  return cases;
}

}  // namespace asos::stability
