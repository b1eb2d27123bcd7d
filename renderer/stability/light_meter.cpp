#include "renderer/stability/light_meter.h"

#include "renderer/scene/make_light.h"
#include "renderer/shading/sky.h"
#include "renderer/stability/closed_forms.h"

#include <cmath>
#include <memory>

namespace asos::stability {
namespace {

/// Large enough that faint lights are above the smallest numbers of float32.
constexpr float albedo = 1 << 20;

}  // namespace

Result<Outcome> LightMeter::measure(const Measure& measure, double lux) const {
  const double h = floor_half;
  Scene scene = scene_of({}, parallel({0, 8, 0}, {0, 0, 0}, 1e-9));
  Material chalk = matte(albedo);
  chalk.specular = 0.0f;  // gloss would reduce the diffuse reflection
  place(scene, mesh_of({{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}}), chalk);
  RenderSettings settings = settings_of(1, 1, max_level);
  // A black sky leaves the light as the only source.
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  if (change) settings = change(settings);
  scene.lights = {make_sun({0, -1, 0})};
  const auto one_lux = render(scene, settings);
  if (!one_lux) return unexpected(one_lux.error());
  const double per_lux = one_lux->at(0, 0);

  // Blockers are not in front of the pixel, so it stays visible.
  for (const Face& face : blockers) place(scene, mesh_of(face.corners), matte(0.0f));
  scene.lights = lights;
  Measure told = measure;
  told.bound = (measure.bound + 3.0 * 16.0 * rounding) * lux;
  told.reason +=
      "; and 16 roundings of float32 of the light's irradiance and of each of the two pictures "
      "that give the lux";
  return one_value(told, lux, render(scene, settings),
                   [&](const Picture& p) { return p.at(0, 0) / per_lux; });
}

}  // namespace asos::stability
