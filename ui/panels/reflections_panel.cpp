#include "ui/panels/reflections_panel.h"

#include "renderer/comparison/method.h"
#include "renderer/shading/surface.h"
#include "ui/panels/dfr_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

/// The first curve when editing starts: that of figure 18.
constexpr DfrCurve first_curve{0.05, 1.0, 32.0};

const std::array<std::string, 4> curved_ways{"approximate", "tangent plane", "split to MAX",
                                             "adaptive"};
static_assert(curved_ways.size() == static_cast<std::size_t>(CurvedMirror::adaptive) + 1);

constexpr std::array blur_sources{
    Controls::Option{"Per material", "Each material uses its own DFR or its roughness."},
    Controls::Option{"Global", "One DFR for all mirrors."},
};

Dfr first_dfr() {
  Dfr dfr;
  dfr.rgb.fill(first_curve);
  return dfr;
}

/// The material at the picked pixel, and the angle of incidence there.
struct PickedMirror {
  std::uint32_t material = 0;
  double incidence_rad = 0.0;
};

std::optional<PickedMirror> picked_mirror(const Previewer& previewer,
                                          std::optional<glm::ivec2> picked) {
  if (!picked) return std::nullopt;
  const Hit hit = previewer.viewpoint().seen_at(picked->x + 0.5, picked->y + 0.5);
  if (!hit.valid()) return std::nullopt;
  const RenderScene& scene = *previewer.scene();
  const glm::vec3 direction(
      previewer.viewpoint().view().ray(picked->x + 0.5, picked->y + 0.5).direction);
  const SurfacePoint point = surface_point(scene.world(), scene.render_features, hit, -direction);
  const double cosine = std::abs(glm::dot(glm::dvec3(point.shading_normal), glm::dvec3(direction)));
  const Part& part = scene.world().parts[scene.world().triangle_part[hit.triangle]];
  return PickedMirror{part.material, std::acos(std::clamp(cosine, 0.0, 1.0))};
}

/// Lists the mirrors once per scene, and selects the one that was clicked in the picture.
void follow(const Previewer& previewer, ReflectionChoice& choice, std::optional<glm::ivec2> picked,
            const std::optional<PickedMirror>& seen) {
  if (choice.scene != previewer.scene().times_opened()) {
    choice = {};
    choice.scene = previewer.scene().times_opened();
    choice.mirrors = mirror_materials(previewer.scene()->world());
  }
  if (picked == choice.followed) return;
  choice.followed = picked;
  const int at = seen ? find_mirror(choice.mirrors, seen->material) : -1;
  if (at >= 0) choice.material = at;
}

void bounce_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  controls.slider("Bounces",
                  "Maximum mirror bounces, 0 to 64. 0: no reflections. Ctrl+click to type a value.",
                  settings.mirror.bounces, {0, MirrorSettings::max_bounces, usual.mirror.bounces},
                  [](int n) { return n == 0 ? std::string("0 (none)") : std::to_string(n); });
  if (settings.mirror.bounces == 0) return;
  controls.slider("Max. roughness",
                  "Largest roughness that reflects the scene, 0 to 1. Rougher surfaces reflect the "
                  "mean sky.",
                  settings.mirror.roughest, {0.0, 1.0, usual.mirror.roughest},
                  [](float r) { return fmt::format("{:.2f}", r); });
}

/// Controls of one material's curve, or a note that it has none.
void material_controls(Controls& controls, Previewer& previewer, ReflectionChoice& choice,
                       std::optional<double> incidence_rad) {
  std::vector<std::string> names;
  for (const MirrorMaterial& mirror : choice.mirrors) names.push_back(mirror.name);
  choice.material = std::clamp(choice.material, 0, static_cast<int>(names.size()) - 1);
  controls.list("Material", "Mirror material to edit. Clicking the picture chooses one.", names,
                choice.material);
  const MirrorMaterial& mirror = choice.mirrors[static_cast<std::size_t>(choice.material)];
  const std::uint32_t first = mirror.members.front();
  const std::optional<Dfr>& original = previewer.scene()->world().materials[first].dfr;
  std::optional<Dfr> dfr = previewer.edits().dfrs()[first];
  bool own = dfr.has_value();
  bool changed =
      controls.checkbox("Blur curve (DFR) instead of roughness",
                        "Blur reflections by the curve of a DFR.", own, original.has_value());
  if (changed) dfr = own ? std::optional(original.value_or(first_dfr())) : std::nullopt;
  if (dfr)
    changed |=
        dfr_editor(controls, *dfr, choice.channel, original.value_or(first_dfr()), incidence_rad);
  if (!changed) return;
  for (const std::uint32_t member : mirror.members) previewer.edits().edit_dfrs()[member] = dfr;
}

}  // namespace

void curved_mirror_controls(Controls& controls, RenderSettings& settings) {
  const RenderSettings usual;
  // The other methods trace single rays.
  if (!in_object_space(settings.method) || settings.mirror.bounces == 0) return;
  int way = static_cast<int>(settings.mirror.curved);
  if (controls.list(
          "Curved mirrors",
          "Reflection on curved mirrors (CGF'98 section 5.2). approximate: nearest pyramid. "
          "tangent plane: fastest, wrong on strong curvature. split to MAX: tangent planes at the "
          "deepest level. adaptive: split where corner rays diverge.",
          curved_ways, way, static_cast<int>(usual.mirror.curved)))
    settings.mirror.curved = static_cast<CurvedMirror>(way);
  if (settings.mirror.curved != CurvedMirror::adaptive) return;
  controls.slider("Divergence",
                  "Largest angle between reflected corner rays, 0 to 180 degrees. Meshes use an "
                  "eighth of it.",
                  settings.mirror.widest_angle_deg, {0.0, 180.0, usual.mirror.widest_angle_deg},
                  degree_words);
}

void reflections_panel(Controls& controls, Previewer& previewer, ReflectionChoice& choice,
                       std::optional<glm::ivec2> picked) {
  if (!previewer.scene()) return;
  const std::optional<PickedMirror> seen = picked_mirror(previewer, picked);
  follow(previewer, choice, picked, seen);
  if (choice.mirrors.empty() || !controls.section("Reflections")) return;
  RenderSettings& settings = previewer.edits().settings();
  bounce_controls(controls, settings);
  if (settings.mirror.bounces == 0) return;

  int source = settings.mirror.dfr ? 1 : 0;
  if (controls.options("DFR", blur_sources, source, {true, 0})) {
    settings.mirror.dfr.reset();
    if (source == 1) settings.mirror.dfr = first_dfr();
  }
  const int at = seen ? find_mirror(choice.mirrors, seen->material) : -1;
  std::optional<double> incidence_rad;
  if (settings.mirror.dfr) {
    if (at >= 0) incidence_rad = seen->incidence_rad;
    (void)dfr_editor(controls, *settings.mirror.dfr, choice.channel, first_dfr(), incidence_rad);
  } else {
    if (at >= 0 && at == choice.material) incidence_rad = seen->incidence_rad;
    material_controls(controls, previewer, choice, incidence_rad);
  }
}

}  // namespace asos::ui
