#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

// Settings at and beyond the ends of their ranges, and settings that must not change a picture.

namespace asos::stability {
namespace {

constexpr const char* setting_group = "settings";

Case refused(const std::string& name, const std::string& subject, void (*change)(RenderSettings&)) {
  return {name + " is refused", setting_group, true, [subject, change]() -> Result<Outcome> {
            RenderSettings settings = settings_of(picture_side, picture_side);
            change(settings);
            const auto answer = validated(settings);
            const bool named = !answer && answer.error().subject == subject;
            return plain_value({"refused, naming " + subject + " (1: yes)", 0.0, "yes or no"}, 1.0,
                               named ? 1.0 : 0.0);
          }};
}

void add_refusals(std::vector<Case>& cases) {
  using S = RenderSettings;
  cases.push_back(refused("EPS -0.001", "eps", [](S& s) { s.asos.eps = -0.001; }));
  cases.push_back(refused("EPS 1.5", "eps", [](S& s) { s.asos.eps = 1.5; }));
  cases.push_back(refused("EPS not a number", "eps",
                          [](S& s) { s.asos.eps = std::numeric_limits<double>::quiet_NaN(); }));
  cases.push_back(refused("EPS infinite", "eps",
                          [](S& s) { s.asos.eps = std::numeric_limits<double>::infinity(); }));
  cases.push_back(refused("MAX -1", "max", [](S& s) { s.asos.max_level = -1; }));
  cases.push_back(refused("MAX 9", "max", [](S& s) { s.asos.max_level = 9; }));
  cases.push_back(refused("a width of 0", "width", [](S& s) { s.width = 0; }));
  cases.push_back(refused("a height of 32769", "height", [](S& s) { s.height = 32769; }));
  cases.push_back(refused("a crop beyond the picture", "crop", [](S& s) {
    s.crop = {15, 15, 2147483647, 2147483647};
  }));
  cases.push_back(refused("TR 0", "tr", [](S& s) { s.texture.resolution = 0; }));
  cases.push_back(refused("TR 9", "tr", [](S& s) { s.texture.resolution = 9; }));
  cases.push_back(refused("65 bounces", "reflections", [](S& s) { s.mirror.bounces = 65; }));
  cases.push_back(refused("DFRMIN not a number", "dfr", [](S& s) {
    s.mirror.dfr.emplace().rgb[1].min = std::numeric_limits<double>::quiet_NaN();
  }));
  cases.push_back(
      refused("N -1", "dfr", [](S& s) { s.mirror.dfr.emplace().rgb[2].exponent = -1.0; }));
  cases.push_back(refused("0 samples", "spp", [](S& s) { s.sampling.spp = 0; }));
}

/// Compares a face under some settings with exact areas; `more` is an additional error, as a
/// fraction of a pixel's area.
Result<Outcome> face_under(const Face& face, const RenderSettings& settings, double more,
                           const std::string& why) {
  const PictureView view{card_camera(), settings.width, settings.height};
  return worst_pixel(
      {fmt::format("radiance of the worst of {}x{} pixels", view.width, view.height),
       rounding_bound(view, {4.0, 2.5, 2, 0.65}) + 0.65 * more, rounding_reason + why},
      render(scene_of({face}, view.camera), settings),
      [&](int x, int y) { return faces_radiance(view, {face}, x, y); });
}

/// A face with one oblique edge within the picture.
Face half_plane() {
  return {{{-0.5, -3, 0}, {4, -3, 0}, {4, 3, 0}, {0.5, 3, 0}}, 1.0f};
}

/// Alternating teeth and gaps, `teeth` of them across the only pixel.
Scene comb(int teeth) {
  Scene scene = scene_of({}, parallel({0, 0, 1}, {0, 0, 0}, 1.0));
  Mesh mesh;
  for (int i = 0; i < teeth; ++i) {
    const double x = static_cast<double>(i) / teeth - 0.5;
    const double half = 0.5 / teeth;
    const Mesh tooth = mesh_of({{x, -1, 0}, {x + half, -1, 0}, {x + half, 1, 0}, {x, 1, 0}});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), tooth.positions.begin(), tooth.positions.end());
    for (const glm::uvec3 t : tooth.triangles) mesh.triangles.push_back(t + first);
  }
  place(scene, mesh, unlit(1.0f));
  return scene;
}

void add_levels(std::vector<Case>& cases) {
  for (const int max : {0, 8}) {
    cases.push_back(
        {fmt::format("a straight edge at MAX {}, EPS 0", max), setting_group, true, [max] {
           return face_under(half_plane(), settings_of(picture_side, picture_side, max), 0.0,
                             "; a straight edge is exact at any level");
         }});
  }
  cases.push_back({"a card at MAX 8, EPS 0", setting_group, true, [] {
                     return face_under(tilted_card(), settings_of(picture_side, picture_side, 8),
                                       std::ldexp(1.0, -16),
                                       "; the finest cell at a corner may stay unresolved");
                   }});
  cases.push_back({"nothing is split at EPS 1", setting_group, true, [] {
                     RenderSettings settings = settings_of(1, 1, 8);
                     settings.asos.eps = 1.0;
                     return one_value(
                         {"deepest level", 0.0, "EPS 1 lets any change of a pixel pass"}, 0.0,
                         render(comb(1024), settings), [](const Picture& p) {
                           return static_cast<double>(p.film.split_level[0]);
                         });
                   }});
  for (const int fat : {2, 16}) {
    cases.push_back({fmt::format("fat pyrays of {0}x{0} pixels", fat), setting_group, true, [fat] {
                       RenderSettings settings = settings_of(37, 19, 5);
                       settings.asos.fat = fat;
                       return face_under(tilted_card(), settings, std::ldexp(1.0, -10),
                                         "; the finest cell at a corner may stay unresolved");
                     }});
  }
  cases.push_back({"the published rule and point leaves at MAX 6, EPS 0", setting_group, true, [] {
                     RenderSettings settings = settings_of(picture_side, picture_side, 6);
                     settings.method = Method::asos_published;
                     return face_under(tilted_card(), settings, 4.0 / 64.0,
                                       "; a convex outline crosses at most 4 times 2^MAX finest "
                                       "cells, each of 4^-MAX of the pixel");
                   }});
}

void add_alternating(std::vector<Case>& cases) {
  for (const int max : {0, 3, 8}) {
    cases.push_back(
        {fmt::format("an object that is in and out 1024 times, MAX {}", max), setting_group, true,
         [max]() -> Result<Outcome> {
           const auto picture = render(comb(1024), settings_of(1, 1, max));
           if (!picture) return unexpected(picture.error());
           // The standard deviation of one sample is half the contrast.
           const double most = 0.325 * (max == 0 ? 1.0 : 4.0 * std::ldexp(1.0, -(max + 1)));
           return one_value(
               {"radiance of the pixel", most + rounding_bound({}, {}),
                "four samples of each of 4^MAX finest cells at most: half the contrast, or "
                "four deviations of their mean"},
               0.5 * (background + 1.0), picture, [](const Picture& p) { return p.at(0, 0); });
         }});
    cases.push_back({fmt::format("the same stops at MAX {}", max), setting_group, true, [max] {
                       return one_value({"deepest level beyond MAX", 0.0, "MAX is the last level"},
                                        0.0, render(comb(1024), settings_of(1, 1, max)),
                                        [max](const Picture& p) {
                                          return std::max(0, p.film.split_level[0] - max);
                                        });
                     }});
  }
}

void add_same(std::vector<Case>& cases) {
  const Measure bits{"radiance of the pixel that differs most", 0.0,
                     "the same work in another order: no bit may differ"};
  cases.push_back({"one worker and seven", setting_group, true, [bits] {
                     RenderSettings settings = settings_of(24, picture_side);
                     const auto one = render(still_life(), settings);
                     settings.threads = 7;
                     return worst_difference(bits, one, render(still_life(), settings));
                   }});
  cases.push_back({"the same picture twice", setting_group, true, [bits] {
                     const RenderSettings settings = settings_of(24, picture_side);
                     return worst_difference(bits, render(still_life(), settings),
                                             render(still_life(), settings));
                   }});
  cases.push_back({"65536 Sobol points in one pixel", setting_group, true, [] {
                     RenderSettings settings = settings_of(1, 1);
                     settings.method = Method::sobol;
                     settings.sampling.spp = 65536;
                     return face_under(half_plane(), settings, 4.0 * 0.5 * std::sqrt(2.72) / 256.0,
                                       "; the deviation is at most that of as many random points, "
                                       "1/2 / 256, times the root of e (Owen 1997): four of them");
                   }});
}

}  // namespace

std::vector<Case> setting_cases() {
  std::vector<Case> cases;
  add_refusals(cases);
  add_levels(cases);
  add_alternating(cases);
  add_same(cases);
  return cases;
}

}  // namespace asos::stability
