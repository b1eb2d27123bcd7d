#include "renderer/comparison/method.h"
#include "renderer/lights/light_kinds.h"
#include "renderer/world/ground.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace asos::ui {

namespace {

// Writes 1234567 as "1 234 567" in every locale.
std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0)
      text += "\u00a0";  // no-break space, so that a number stays in one line
    text += digits[i];
  }
  return text;
}

void light_rows(Controls& controls, const RenderScene& scene) {
  const std::vector<Light>& lights = scene.lights();
  controls.row(
      "Lights",
      scene.lighting->default_lights_added ? std::string("default lights") : grouped(lights.size()),
      "Lights of the file and emissive surfaces. Dark scenes get two soft default lights.");
  for (const auto& [name, type] : light_type_names) {
    const auto count = std::count_if(lights.begin(), lights.end(), [type = type](const Light& l) {
      return l.type == type && l.own_part < 0;
    });
    if (count > 0) {
      controls.row((std::string("   ") + name).c_str(), grouped(static_cast<std::uint64_t>(count)),
                   "Count, including default lights.");
    }
  }
  if (scene.lighting->emissive_lights > 0) {
    controls.row("   emissive", grouped(scene.lighting->emissive_lights),
                 "Lights of emissive surfaces.");
  }
}

// The rows are always shown, so that nothing moves once the search has ended.
void edge_rows(Controls& controls, const BoundaryFeatures& boundaries) {
  FeatureCounts edges;
  if (boundaries.known()) edges = boundaries.get().counts();
  const auto kind = [&](const char* label, std::uint64_t count, const char* tooltip) {
    controls.row(label, boundaries.known() ? grouped(count) : std::string("-"), tooltip);
  };
  if (boundaries.known())
    kind("Edges",
         edges.open + edges.crease + edges.seam + edges.silhouette_candidates + edges.intersection +
             edges.cut_out,
         "Edges of all kinds that may be visible.");
  else
    controls.row("Edges", boundaries.running() ? "(searching)" : "(not searched)",
                 "The search begins when a method needs edges.");
  kind("   open", edges.open, "Edges of one triangle: borders of open surfaces.");
  kind("   crease", edges.crease, "Creases.");
  kind("   seam", edges.seam, "Changes of material or texture coordinates.");
  kind("   smooth", edges.silhouette_candidates,
       "Edges of smooth surfaces, visible as silhouettes.");
  kind("   intersection", edges.intersection, "Intersections of surfaces.");
  kind("   alpha edge", edges.cut_out, "Outline pieces of alpha masks.");
}

/// The savings of leaving `feature` out, one per line.
std::string savings(const RenderFeature& feature) {
  std::string text = "Skipped with it:";
  const auto add = [&](const char* kind, const char* words) {
    if (*words != '\0') text += fmt::format("\n{}: {}", kind, words);
  };
  add("Stages", feature.stages);
  add("Memory", feature.memory);
  add("Controls", feature.controls);
  add("Rows", feature.rows);
  return text;
}

void left_out_rows(Controls& controls, const RenderFeatures& render_features) {
  const std::vector<RenderFeature> left_out = features_left_out(render_features);
  if (left_out.empty() || !controls.section("Skipped work", false)) return;
  for (const RenderFeature& feature : left_out)
    controls.row(feature.name, feature.reason, savings(feature).c_str());
}

}  // namespace

void scene_panel(Controls& controls, const RenderScene& scene, const RenderSettings& settings,
                 double load_seconds) {
  if (!controls.section("Scene")) return;
  const World& world = scene.world();
  controls.row("Triangles", grouped(triangles_without_ground(world)),
               "Triangles, including repeated objects.");
  controls.row("Objects", grouped(parts_without_ground(world)), "Surfaces of one material each.");
  light_rows(controls, scene);
  const Geometry& geometry = *scene.geometry;
  const BoundaryFeatures& boundaries = geometry.boundaries;
  edge_rows(controls, boundaries);
  controls.row("Loaded in", fmt::format("{:.2f} s", load_seconds + geometry.build_seconds),
               fmt::format("{:.2f} s to read the file, {:.2f} s for the ray hierarchy. {:.2f} s "
                           "for edges, while the picture starts.",
                           load_seconds, geometry.build_seconds, boundaries.seconds())
                   .c_str());
  controls.row("Memory", fmt::format("{:.1f} MB", geometry.memory_mb()),
               "Geometry, textures and hierarchies, in megabytes.");
  left_out_rows(controls, needs_of_picture(scene, settings));
}

}  // namespace asos::ui
