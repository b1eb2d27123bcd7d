#include "renderer/scene/make_light.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/light_meter.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// Shadows: blockers in contact, too thin, too near the light, and none.

namespace asos::stability {
namespace {

constexpr const char* shadow_group = "shadows";

/// A square light of side 2 and one nit, 2 above the origin.
Light panel() {
  return make_panel({0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1});
}

/// Illuminance in lux from the part of the panel from x = begin to x = end.
double strip_lux(double begin, double end) {
  return contour_illuminance({{begin, 2, -1}, {end, 2, -1}, {end, 2, 1}, {begin, 2, 1}});
}

/// A level strip at height y; it hides the light's part from 2 x0 / y to 2 x1 / y.
Face strip(double x0, double x1, double y) {
  return {{{x0, y, -8}, {x1, y, -8}, {x1, y, 8}, {x0, y, 8}}, 0.0f};
}

const char* const straight =
    "edges across a light are cut exactly, so that the closed form of what is left is exact but "
    "for "
    "the edge's place";

/// The measure for an edge with an error of 16 roundings of `lengths`, seen at height y.
Measure edge_measure(double lengths, double y) {
  return {"illuminance at the origin, lux", 2.0 * 16.0 * rounding * lengths * 2.0 / y,
          fmt::format("{}: 16 roundings of {:g}, 2 / {:g} times that on the light, of two edges",
                      straight, lengths, y)};
}

/// Hides the panel from x = 1/8 on, at height y. All sizes scale with y, so the error of float32
/// does, too.
Result<Outcome> edge_above(double y) {
  LightMeter meter{{panel()}, {}, 4.0 * y};
  meter.blockers = {{{{y / 16, y, -y}, {y, y, -y}, {y, y, y}, {y / 16, y, y}}, 0.0f}};
  return meter.measure(edge_measure(4.0 * y, y), strip_lux(-1.0, 0.125));
}

/// A wall that stands on the floor next to the point, up to a height.
Result<Outcome> wall_beside(double x, double height, double seen_from) {
  const LightMeter meter{{panel()},
                         {{{{x, 0, -8}, {x, 0, 8}, {x, height, 8}, {x, height, -8}}, 0.0f}}};
  return meter.measure({"illuminance at the origin, lux", 2.0 * 16.0 * rounding * 8.0 * 2.0,
                        std::string(straight) + ": 16 roundings of 8, of two edges, at most twice "
                                                "that on the light"},
                       strip_lux(seen_from, 1.0));
}

void add_edges(std::vector<Case>& cases) {
  // Heights are powers of two, or sums of few.
  for (const double y : {1.9990234375, 1.0, 0.0078125, 0.0001220703125}) {
    cases.push_back({fmt::format("a light partly behind an edge {:.4g} above the point", y),
                     shadow_group, true, [y] { return edge_above(y); }});
  }
  const double x = -0.0001220703125;
  cases.push_back({"a wall that stands on the floor 1e-4 beside the point", shadow_group, true,
                   [x] { return wall_beside(x, 1.0, 2.0 * x); }});
  cases.push_back({"a wall 1e-4 beside the point that passes through the light", shadow_group, true,
                   [x] { return wall_beside(x, 8.0, x); }});
}

void add_thin(std::vector<Case>& cases) {
  for (const double width : {1e-1, 1e-3, 1e-4}) {
    cases.push_back(
        {fmt::format("a wire {:g} wide before a light", width), shadow_group, true, [width] {
           const LightMeter meter{{panel()}, {strip(0.25, 0.25 + width, 1.0)}};
           const double lux = strip_lux(-1.0, 1.0) - strip_lux(0.5, 0.5 + 2.0 * width);
           // The wire's length does not move its edges, which lie within 1 of the centre.
           return meter.measure(edge_measure(1.0, 1.0), lux);
         }});
  }
  cases.push_back({"a blocker of no area", shadow_group, true, [] {
                     const LightMeter meter{{panel()}, {strip(0.25, 0.25, 1.0)}};
                     return meter.measure(
                         {"illuminance at the origin, lux", 0.0, "what has no area hides nothing"},
                         strip_lux(-1.0, 1.0));
                   }});
  cases.push_back({"a blocker in the light's own plane", shadow_group, true, [] {
                     const LightMeter meter{{panel()}, {strip(0.25, 0.5, 2.0)}};
                     return meter.measure({"illuminance at the origin, lux", 0.0,
                                           "a light's own surface, which lies there, hides nothing "
                                           "of it, and neither does what coincides with it"},
                                          strip_lux(-1.0, 1.0));
                   }});
  cases.push_back({"a blocker 1e-4 beyond the light", shadow_group, true, [] {
                     const LightMeter meter{{panel()}, {strip(0.25, 0.5, 2.0001220703125)}};
                     return meter.measure({"illuminance at the origin, lux", 0.0,
                                           "what lies behind a light hides nothing of it"},
                                          strip_lux(-1.0, 1.0));
                   }});
  cases.push_back({"a blocker 1e-4 before the light", shadow_group, true, [] {
                     const double y = 1.9998779296875;
                     const LightMeter meter{{panel()}, {strip(0.25, 0.5, y)}};
                     const double lux = strip_lux(-1.0, 1.0) - strip_lux(0.5 / y, 1.0 / y);
                     return meter.measure(edge_measure(8.0, y), lux);
                   }});
}

void add_full(std::vector<Case>& cases) {
  cases.push_back(
      {"a light wholly hidden by what stands 1e-3 above", shadow_group, true, [] {
         LightMeter meter{{panel()}, {}};
         // The blocker hides the pixel from the light, but not from the camera.
         meter.lights[0].position.x = 4.0;
         meter.blockers = {strip(0.0001220703125, 8.0, 0.0009765625)};
         return meter.measure(
             {"illuminance at the origin, lux", 0.0, "the blocker hides all of the light"}, 0.0);
       }});
  cases.push_back({"a thousand blockers behind one another", shadow_group, true, [] {
                     LightMeter meter{{panel()}, {}};
                     for (int i = 0; i < 1000; ++i) {
                       const double y = 0.5 + 0.001 * i;
                       meter.blockers.push_back(strip(0.25 * y, 8.0, y));
                     }
                     Measure measure = edge_measure(8.0, 0.5);
                     // A radiance of 1 is pi lux.
                     measure.bound += 0.5 / 256.0 * std::numbers::pi;
                     measure.reason +=
                         "; the edges all lie in one plane through the point; so many may be taken "
                         "for a thicket, which is sampled to half of what MAX 3 lets pass, 1/256";
                     return meter.measure(measure, strip_lux(-1.0, 0.5));
                   }});
}

}  // namespace

std::vector<Case> shadow_cases() {
  std::vector<Case> cases;
  add_edges(cases);
  add_thin(cases);
  add_full(cases);
  return cases;
}

}  // namespace asos::stability
