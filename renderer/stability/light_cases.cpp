#include "renderer/scene/make_light.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/light_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

// Lights without size, of huge size, at unusual places, too weak, too strong, too many.

namespace asos::stability {
namespace {

using std::numbers::pi;

constexpr const char* light_group = "lights";

constexpr glm::dvec3 down(0, -1, 0);

Light disk(double height, double radius) {
  return make_disk({0, height, 0}, down, radius);
}

Light ball(glm::dvec3 position, double radius) {
  // Scale so that its radiance is one nit.
  return make_bulb(position, static_cast<float>(radius > 0.0 ? pi * radius * radius : 1.0), radius);
}

Light rectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v, glm::dvec3 direction) {
  return make_panel(middle, direction, half_u, half_v);
}

std::vector<glm::dvec3> corners_of(const Light& r) {
  const glm::dvec3 c = r.position;
  return {c - r.half_u - r.half_v, c + r.half_u - r.half_v, c + r.half_u + r.half_v,
          c - r.half_u + r.half_v};
}

const char* const closed = "the closed form is exact";

Case under(const std::string& name, const LightMeter& meter, double lux,
           const Measure& measure = {"illuminance at the origin, lux", 0.0, closed}) {
  return {name, light_group, true, [=] { return meter.measure(measure, lux); }};
}

/// A disk of one nit straight above.
double disk_lux(double height, double radius) {
  return pi * radius * radius / (radius * radius + height * height);
}

void add_light_sizes(std::vector<Case>& cases) {
  cases.push_back(under("a point light", {{make_bulb({0, 2, 0})}, {}}, 0.25));
  cases.push_back(under("a ball of radius 0 is a point", {{ball({0, 2, 0}, 0.0)}, {}}, 0.25));
  cases.push_back(under("a ball of radius 1e-12", {{ball({0, 2, 0}, 1e-12)}, {}}, pi * 2.5e-25));
  cases.push_back(under("a disk of radius 0 gives nothing", {{disk(2.0, 0.0)}, {}}, 0.0));
  cases.push_back(under("a rectangle of no width gives nothing",
                        {{rectangle({0, 2, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0})}, {}}, 0.0));
  cases.push_back(under("a line of length 0 is a point", {{make_tube({0, 2, 0}, {})}, {}}, 0.25));
  const Light empty = make_polygon(down, {{{0, 2, 0}, {1, 2, 0}}});
  cases.push_back(under("a polygon of two corners gives nothing", {{empty}, {}}, 0.0));
  const Light dot = make_sun(down, 1.0f, 1e-9);
  cases.push_back(under("a sun of 1e-9 radians gives its lux", {{dot}, {}}, 1.0));
  cases.push_back(
      under("a disk of radius 1e6, 1 above", {{disk(1.0, 1e6)}, {}}, disk_lux(1.0, 1e6)));
  cases.push_back(under("a disk of radius 1e-6, 1 above, of 1e12 nits",
                        {{[] {
                           Light light = disk(1.0, 1e-6);
                           light.intensity = 1e12f;
                           return light;
                         }()},
                         {}},
                        1e12 * disk_lux(1.0, 1e-6)));
  const Light wide = rectangle({0, 1, 0}, {1e6, 0, 0}, {0, 0, 1e6}, {0, -1, 0});
  cases.push_back(
      under("a rectangle 2e6 wide, 1 above", {{wide}, {}}, contour_illuminance(corners_of(wide))));
  cases.push_back(under("a ball of radius 1e6, its surface 1 above",
                        {{ball({0, 1e6 + 1.0, 0}, 1e6)}, {}},
                        pi * std::pow(1e6 / (1e6 + 1.0), 2.0)));
}

void add_cones(std::vector<Case>& cases) {
  for (const double outer : {1e-6, 0.1, 1.5707963}) {
    const Light spot = make_spot({0, 2, 0}, down, outer, outer);
    // The extension's formula with its guard: (cos - cos outer) / 0.001, squared, at most 1.
    const double below_1 = 2.0 * std::sin(0.5 * outer) * std::sin(0.5 * outer);  // 1 - cos(outer)
    const double share = std::min(1.0, below_1 / 0.001);
    const double cosine_rounding = 2.0 * std::numeric_limits<double>::epsilon() / below_1;
    // At a point off the axis, 2 below the light, the cosine is less by half the squared angle.
    constexpr double half_side = 1e-3;
    const double beside = 16.0 * rounding * half_side / 2.0;
    cases.push_back(
        under(fmt::format("a spot whose cones are both {:g} radians", outer),
              {{spot}, {}, half_side}, 0.25 * share * share,
              {"illuminance at the origin, lux", cosine_rounding + beside * beside / below_1,
               "the closed form, in which the cosine of the cone, rounded to a double, "
               "counts squared, as does that of the point's place, which may be 16 "
               "roundings of the floor's half side of 1e-3 off"}));
  }
  Light near = make_bulb({0, 2, 0});
  near.range = 1e-6;
  cases.push_back(under("a point light whose range ends before the point", {{near}, {}}, 0.0));
}

void add_places(std::vector<Case>& cases) {
  const Light touching = rectangle({0.5, 1, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0});
  cases.push_back(under("a rectangle that stands on the receiver", {{touching}, {}},
                        contour_illuminance(corners_of(touching))));
  const Light crossing = rectangle({0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0});
  cases.push_back(under("a rectangle half below the receiver", {{crossing}, {}},
                        contour_illuminance(corners_of(crossing))));
  const Light beside = rectangle({1e-6, 1, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0});
  cases.push_back(under(
      "a rectangle that stands 1e-6 beside the point", {{beside}, {}, 1e-3},
      contour_illuminance(corners_of(beside)),
      {"illuminance at the origin, lux", 16.0 * rounding * 1e-3 / 1e-6,
       "the point may be 16 roundings of the floor's half side of 1e-3 off, beside a distance "
       "of 1e-6"}));
  cases.push_back(under("a rectangle in the receiver's plane gives nothing",
                        {{rectangle({2, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0})}, {}}, 0.0));
  cases.push_back(under("a rectangle in the receiver's plane around the point, facing down",
                        {{rectangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0})}, {}}, 0.0));
  cases.push_back(under("a rectangle below the horizon gives nothing",
                        {{rectangle({0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0})}, {}}, 0.0));
  const Light low = rectangle({0, 1e-6, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0});
  cases.push_back(under("a rectangle 1e-6 above the surface", {{low}, {}},
                        contour_illuminance(corners_of(low))));
  cases.push_back(
      under("a disk 1e-6 above the surface", {{disk(1e-6, 1.0)}, {}}, disk_lux(1e-6, 1.0)));
  cases.push_back(
      under("a point light at the very point gives nothing", {{make_bulb({0, 0, 0})}, {}}, 0.0));
  cases.push_back(
      under("a point light 1e-6 above the point", {{make_bulb({0, 1e-6, 0})}, {}, 1e-3}, 1e12,
            {"illuminance at the origin, lux", 3.0 * std::pow(16.0 * rounding * 1e-3 / 1e-6, 2.0),
             "the point may be 16 roundings of the floor's half side of 1e-3 beside its place, "
             "which counts squared, three halves of it"}));
  cases.push_back(under("a point light 1e6 away", {{make_bulb({0, 1e6, 0}, 1e12f)}, {}},
                        static_cast<double>(1e12f) / 1e12));
  cases.push_back(under("a ball around the point", {{ball({0.3, 0.2, 0}, 1.0)}, {}}, pi));
  cases.push_back(
      under("a ball around the camera and the point", {{ball({0, 4, 0}, 16.0)}, {}}, pi));
  cases.push_back(under("a ball half below the receiver", {{ball({2, 0, 0}, 1.0)}, {}}, [] {
    // The upper half of the cap, of half angle a, that a ball on the horizon fills.
    const double a = std::asin(0.5);
    return a - std::sin(a) * std::cos(a);
  }()));
}

void add_strengths(std::vector<Case>& cases) {
  for (const float intensity : {1e-20f, 1e-6f, 1e6f, 1e20f}) {
    Light light = disk(1.0, 1.0);
    light.intensity = intensity;
    cases.push_back(under(fmt::format("a disk of {:g} nits", intensity), {{light}, {}},
                          static_cast<double>(intensity) * disk_lux(1.0, 1.0)));
  }
  LightMeter many;
  for (int i = 0; i < 4096; ++i) {
    const double angle = 2.0 * pi * i / 4096.0;
    many.lights.push_back(make_bulb({std::cos(angle), 1, std::sin(angle)}, 1.0f / 4096.0f));
  }
  cases.push_back(under("4096 point lights on a ring", many, 1.0 / (2.0 * std::sqrt(2.0)),
                        {"illuminance at the origin, lux", 4096.0 * rounding,
                         "4096 sums of float32, each rounded once"}));
  LightMeter areas;
  for (int i = 0; i < 1024; ++i) {
    const double x = 0.125 * (i % 32) - 1.9375;
    const double z = 0.125 * (i / 32) - 1.9375;
    areas.lights.push_back(rectangle({x, 1, z}, {0.0625, 0, 0}, {0, 0, 0.0625}, {0, -1, 0}));
  }
  areas.max_level = max_level_limit;  // a smaller MAX samples the lights together
  const Light whole = rectangle({0, 1, 0}, {2, 0, 0}, {0, 0, 2}, {0, -1, 0});
  cases.push_back(under("1024 rectangles that are one", areas,
                        contour_illuminance(corners_of(whole)),
                        {"illuminance at the origin, lux", 1024.0 * rounding,
                         "1024 sums of float32, each rounded once"}));
}

}  // namespace

std::vector<Case> light_cases() {
  std::vector<Case> cases;
  add_light_sizes(cases);
  add_cones(cases);
  add_places(cases);
  add_strengths(cases);
  return cases;
}

}  // namespace asos::stability
