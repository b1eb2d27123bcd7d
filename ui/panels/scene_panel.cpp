#include "renderer/settings/names.h"
#include "renderer/world/ground.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace asos {

namespace {

// 1234567 as "1 234 567", whatever the locale.
std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0)
      text += "\u00a0";  // so that a number stays in its line
    text += digits[i];
  }
  return text;
}

void light_rows(Controls& controls, const RenderScene& scene) {
  const std::vector<Light>& lights = scene.lights();
  controls.row("Lights",
               scene.lighting->default_rig ? std::string("studio rig") : grouped(lights.size()),
               "Lights of the file, and surfaces that shine. Where all of them together give next "
               "to nothing, a rig of two soft lights is added, so that the picture is not black.");
  for (const auto& [name, type] : light_type_names) {
    const auto count = std::count_if(lights.begin(), lights.end(), [type = type](const Light& l) {
      return l.type == type && l.own_part < 0;
    });
    if (count > 0) {
      controls.row((std::string("   ") + name).c_str(), grouped(static_cast<std::uint64_t>(count)),
                   "Lights of this type, those of the studio rig included.");
    }
  }
  if (scene.lighting->emissive_lights > 0) {
    controls.row("   emissive", grouped(scene.lighting->emissive_lights),
                 "Lights that stand for surfaces of emissive materials.");
  }
}

void edge_rows(Controls& controls, const FeatureCounts& edges) {
  controls.row("Edges",
               grouped(edges.open + edges.crease + edges.seam + edges.silhouette_candidates +
                       edges.intersection + edges.cut_out),
               "Edges that can be boundaries in the picture, of all kinds.");
  const auto kind = [&](const char* label, std::uint64_t count, const char* tooltip) {
    if (count > 0) controls.row(label, grouped(count), tooltip);
  };
  kind("   open", edges.open, "Edges of one triangle only: rims of open surfaces.");
  kind("   crease", edges.crease, "Edges where the surface has a kink.");
  kind("   seam", edges.seam, "Edges where the material or the texture coordinates change.");
  kind("   smooth", edges.silhouette_candidates,
       "Edges of smooth surfaces: boundaries only where the surface turns away from the eye.");
  kind("   crossing", edges.intersection, "Lines in which surfaces pass through each other.");
  kind("   cut-out", edges.cut_out, "Pieces of the outlines of what textures cut out of surfaces.");
}

/// The savings of leaving `feature` out, line by line.
std::string savings(const SceneFeature& feature) {
  std::string text = "Left out with it, at no cost:";
  const auto add = [&](const char* kind, const char* words) {
    if (*words != '\0') text += fmt::format("\n{}: {}", kind, words);
  };
  add("Stages", feature.stages);
  add("Memory", feature.memory);
  add("Controls", feature.controls);
  add("Rows", feature.rows);
  return text;
}

void left_out_rows(Controls& controls, const SceneNeeds& needs) {
  const std::vector<SceneFeature> left_out = features_left_out(needs);
  if (left_out.empty() || !controls.section("Left out", false)) return;
  for (const SceneFeature& feature : left_out)
    controls.row(feature.name, feature.reason, savings(feature).c_str());
}

}  // namespace

void scene_panel(Controls& controls, const RenderScene& scene, const RenderSettings& settings,
                 double load_seconds) {
  if (!controls.section("Scene")) return;
  const World& world = scene.world();
  controls.row("Triangles", grouped(triangles_without_ground(world)),
               "All of them, those of repeated objects counted each time.");
  controls.row("Objects", grouped(world.parts.size()), "Surfaces of one material each.");
  light_rows(controls, scene);
  const Geometry& geometry = *scene.geometry;
  const BoundaryFeatures& boundaries = geometry.boundaries;
  if (boundaries.known()) {
    edge_rows(controls, boundaries.get().counts());
  } else {
    controls.row("Edges", "not known yet", "Edges that can be boundaries are being looked for.");
  }
  controls.row("Loaded in", fmt::format("{:.2f} s", load_seconds + geometry.build_seconds),
               fmt::format("Seconds: {:.2f} to read the file, {:.2f} to build what rays need; "
                           "{:.2f} more to find the boundaries, while the picture begins.",
                           load_seconds, geometry.build_seconds, boundaries.seconds())
                   .c_str());
  controls.row("Memory", fmt::format("{:.1f} MB", geometry.memory_mb()),
               "Of geometry, textures and hierarchies, in millions of bytes.");
  left_out_rows(controls, needs_of(scene, settings));
}

}  // namespace asos
