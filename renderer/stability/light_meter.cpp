#include "renderer/stability/light_meter.h"

#include "renderer/stability/closed_forms.h"

#include <algorithm>
#include <cmath>

namespace asos::stability {
namespace {

/// So bright that what gloss adds is below its rounding: the sky and Fresnel's term reflect at most
/// all of the light, the floor a million times that.
constexpr float albedo = 1 << 20;

Light sun(double down) {
  Light light;
  light.type = Light::Type::directional;
  light.direction = {0, down, 0};
  return light;
}

}  // namespace

Result<Outcome> LightMeter::measure(const Measure& measure, double lux) const {
  const double h = floor_half;
  Scene scene = scene_of({}, parallel({0, 8, 0}, {0, 0, 0}, 1e-9));
  place(scene, mesh_of({{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}}), matte(albedo));
  RenderSettings settings = settings_of(1, 1, max_level);
  if (change) settings = change(settings);
  scene.lights = {sun(1.0)};  // from below: dark, and yet no scene without lights
  const auto dark = render(scene, settings);
  scene.lights = {sun(-1.0)};
  const auto one_lux = render(scene, settings);
  if (!dark) return unexpected(dark.error());
  if (!one_lux) return unexpected(one_lux.error());
  const double black = dark->at(0, 0);
  const double per_lux = one_lux->at(0, 0) - black;

  // Blockers stand beside the pixel, not before it.
  for (const Face& face : blockers) place(scene, mesh_of(face.corners), matte(0.0f));
  scene.lights = lights;
  // Sixteen roundings each of the light's irradiance, of the sum and of the three pictures.
  Measure told = measure;
  told.bound =
      measure.bound * std::max(1.0, lux) + 16.0 * rounding * (lux + 3.0 * (black / per_lux + 1.0));
  told.reason += "; and 16 roundings of float32 of each of the three pictures that give the lux";
  return one_value(told, lux, render(scene, settings),
                   [&](const Picture& p) { return (p.at(0, 0) - black) / per_lux; });
}

}  // namespace asos::stability
