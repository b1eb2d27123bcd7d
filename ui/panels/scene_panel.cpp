#include "ui/panels/panels.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cstdint>
#include <string>

namespace asos {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// 1234567 as "1 234 567", whatever the locale.
std::string grouped(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

std::string lights_of(const RenderScene& scene) {
  if (scene.default_rig) return "none: default lights";
  return std::to_string(scene.world.lights.size());
}

// What a person should know before trusting the picture.
std::vector<std::string> remarks(const SceneNotes& notes) {
  std::vector<std::string> lines = notes.warnings;
  if (!notes.unsupported_extensions.empty()) {
    lines.push_back("not supported: " + joined(notes.unsupported_extensions));
  }
  if (notes.points_not_drawn > 0) {
    lines.push_back(fmt::format("{} points are not drawn", notes.points_not_drawn));
  }
  if (notes.lines_not_drawn > 0) {
    lines.push_back(fmt::format("{} line segments are not drawn", notes.lines_not_drawn));
  }
  return lines;
}

}  // namespace

void scene_panel(Controls& controls, const RenderScene& scene, double load_seconds) {
  if (!controls.section("Scene")) return;
  const World& world = scene.world;
  controls.row("Triangles", grouped(world.triangles.size()));
  controls.row("Objects", grouped(world.parts.size()));
  controls.row("Lights", lights_of(scene),
               "Point, spot and directional lights of the file. A scene without lights gets "
               "default ones, so that it is not black.");
  const FeatureCounts& edges = scene.features.counts();
  controls.row("Edges",
               grouped(edges.open + edges.crease + edges.seam + edges.silhouette_candidates),
               fmt::format("Edges that can be boundaries in the picture: {} open, {} creases, {} "
                           "seams, and {} smooth ones, which are boundaries only where the surface "
                           "turns away from the eye.",
                           grouped(edges.open), grouped(edges.crease), grouped(edges.seam),
                           grouped(edges.silhouette_candidates))
                   .c_str());
  const std::vector<std::string> left_out = scene.needs.left_out();
  if (!left_out.empty()) {
    controls.row("Left out", joined(left_out), "What this scene does not need costs nothing.");
  }
  controls.row("Loaded in", fmt::format("{:.2f} s", load_seconds + scene.build_seconds),
               "Reading the file and building the hierarchies.");
  controls.row("Memory", fmt::format("{:.1f} MB", scene.memory_mb));

  const std::vector<std::string> lines = remarks(scene.notes);
  if (lines.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::warning));
  ImGui::PushTextWrapPos(0.0f);
  for (const std::string& line : lines) ImGui::TextUnformatted(line.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  controls.placed("Warnings", nullptr);
}

}  // namespace asos
