#include "renderer/settings/names.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr std::array light_rules{
    Controls::Option{"Physical",
                     "Inverse-square falloff, integrated over the visible part of the light."},
    Controls::Option{
        "Published",
        "As published: area lights count by their visible fraction, distance and angle."},
};

bool divides(ShadowQuality quality) {
  return quality == ShadowQuality::supersampling || quality == ShadowQuality::forced ||
         quality == ShadowQuality::extended_divided;
}

void quality_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  std::vector<std::string> names;
  for (const auto& named : shadow_quality_names) names.emplace_back(named.name);
  static_assert(shadow_quality_names.back().value == ShadowQuality::extended_adaptive);
  int chosen = static_cast<int>(settings.shadow.quality);
  if (controls.list("Soft shadows",
                    "Method for soft shadows. refined: one look at the light per patch, split "
                    "where it varies. centre: one look. supersampling, forced: n x n jittered or "
                    "regular points. extended: a look from behind the patch, whole or divided.",
                    names, chosen, static_cast<int>(usual.shadow.quality))) {
    settings.shadow.quality = static_cast<ShadowQuality>(chosen);
  }
  if (!divides(settings.shadow.quality)) return;
  controls.slider("Divisions", "Divisions of a patch, n x n, 1 to 16. Ctrl+click to type a value.",
                  settings.shadow.divisions, {1, 16, usual.shadow.divisions},
                  [](int n) { return fmt::format("{} x {}", n, n); });
}

}  // namespace

void shadows_panel(Controls& controls, RenderSettings& settings, const RenderScene* scene) {
  const RenderSettings usual;
  if (!controls.section("Shadows")) return;
  if (scene && scene->render_features.shadows)
    controls.checkbox("Shadows", "Lights cast shadows.", settings.shadow.cast, usual.shadow.cast);
  if (settings.shadow.cast)
    controls.checkbox("Ambient occlusion",
                      "Objects block sky light from each other (contact shadows). Off is faster.",
                      settings.shadow.sky, usual.shadow.sky);
  if (settings.shadow.cast) {
    bool bounces = settings.shadow.bounces > 0;
    controls.checkbox(
        "Indirect light (1 bounce)",
        "Surfaces light each other by one diffuse bounce. Includes ambient occlusion. Slower.",
        bounces, usual.shadow.bounces > 0);
    settings.shadow.bounces = bounces ? 1 : 0;
  }
}

void shadow_rules(Controls& controls, RenderSettings& settings, const RenderScene* scene) {
  const RenderSettings usual;
  // The published method has fixed quality and rule.
  const bool soft = scene && scene->render_features.soft_shadows;
  if (settings.method == Method::asos && settings.shadow.cast && soft)
    quality_controls(controls, settings);
  if (settings.method == Method::asos_published) return;
  controls.options("Light rule", light_rules, settings.shadow.light_rule, usual.shadow.light_rule);
}

}  // namespace asos::ui
