#include "ui/panels/outline_panel.h"

#include "ui/panels/inner_list.h"
#include "ui/panels/named_like.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asos {

namespace {

constexpr float list_rows = 12.5f;

std::string name_or(const std::string& name, const char* kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : printable(name);
}

// A click on the picture selects what it shows.
void follow(const Previewer& previewer, OutlineChoice& choice, std::optional<glm::ivec2> picked) {
  if (picked == choice.followed) return;
  choice.followed = picked;
  if (!picked) return;
  const Hit hit = previewer.viewpoint().seen_at(picked->x + 0.5, picked->y + 0.5);
  const World& world = previewer.scene()->world();
  choice.selected = hit.valid() ? static_cast<int>(world.triangle_part[hit.triangle]) : -1;
  choice.scroll_to_selected = choice.selected >= 0;
}

std::string buttons(Controls& controls, Previewer& previewer, OutlineChoice& choice) {
  OpenScene& scene = previewer.scene();
  const float width =
      (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
  const auto parts = static_cast<int>(scene->world().parts.size());
  const bool chosen = choice.selected >= 0 && choice.selected < parts;
  std::string said;
  const auto act = [&](bool possible, auto change) {
    if (!chosen) {
      said = "No object chosen: click one in the picture or list";
    } else if (!possible) {
      said = "No other object";
    } else {
      change();
      choice.selected = -1;
      said = "Saved pictures do not store hidden objects";
    }
  };
  if (controls.button("Hide", "Hide the object with its light and shadow.", width))
    act(parts > 1, [&] { scene.hide(choice.selected); });
  ImGui::SameLine();
  if (controls.button("Isolate", "Show only the chosen object.", width))
    act(parts > 1, [&] { scene.show_only(choice.selected); });
  ImGui::SameLine();
  if (controls.button("Show all", "Show all hidden objects.", width)) {
    said = scene.hidden().empty() ? "Nothing hidden" : "All objects shown";
    if (!scene.hidden().empty()) scene.show_all();
  }
  return said;
}

void material_row(Controls& controls, const Material& material, std::size_t index,
                  std::size_t objects) {
  ImGui::TextUnformatted(name_or(material.name, "Material", index).c_str());
  controls.placed("Listed material/" + std::to_string(index + 1), "Material of the scene.");
  ImGui::SameLine();
  ImGui::TextDisabled("%s", fmt::format("{}", objects).c_str());
  std::string asked;
  for (const std::string& name : extensions_of(material))
    asked += (asked.empty() ? "" : ", ") + name;
  if (asked.empty()) return;
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextDisabled("%s", asked.c_str());
  ImGui::PopTextWrapPos();
}

// To the one of the objects, which are about to be listed, that is selected, if it is one of them.
void scroll_to_selected(const std::vector<std::size_t>& objects, OutlineChoice& choice) {
  const auto at = std::lower_bound(objects.begin(), objects.end(), choice.selected,
                                   [](std::size_t i, int s) { return static_cast<int>(i) < s; });
  if (at == objects.end() || static_cast<int>(*at) != choice.selected) return;
  const auto row = static_cast<float>(at - objects.begin());
  ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() +
                           row * ImGui::GetTextLineHeightWithSpacing());
  choice.scroll_to_selected = false;
}

// Each material, and below it the objects that have it.
void tree(Controls& controls, const World& world, OutlineChoice& choice) {
  std::vector<std::vector<std::size_t>> objects(world.materials.size());
  for (std::size_t i = 0; i < world.parts.size(); ++i)
    if (named_like(name_or(world.parts[i].name, "Object", i), choice.find))
      objects[world.parts[i].material].push_back(i);
  const InnerList list("outline", {0.0f, list_rows * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t m = 0; m < objects.size(); ++m) {
    if (objects[m].empty()) continue;
    material_row(controls, world.materials[m], m, objects[m].size());
    ImGui::Indent();
    if (choice.scroll_to_selected) scroll_to_selected(objects[m], choice);
    // Scenes hold many thousands: only what is seen is laid out.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(objects[m].size()));
    while (clipper.Step()) {
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
        const std::size_t i = objects[m][static_cast<std::size_t>(row)];
        const auto at = static_cast<int>(i);
        ImGui::PushID(at);
        if (ImGui::Selectable(name_or(world.parts[i].name, "Object", i).c_str(),
                              at == choice.selected))
          choice.selected = at == choice.selected ? -1 : at;
        controls.placed("Object/" + std::to_string(i + 1),
                        "Object with this material. Click to choose it.", Controls::Use::edits);
        ImGui::PopID();
      }
    }
    ImGui::Unindent();
  }
}

}  // namespace

std::vector<std::string> extensions_of(const Material& m) {
  const Material usual;
  struct Asked {
    bool used;
    const char* name;
  };
  const Asked all[] = {
      {m.anisotropy.used(), "anisotropy"},
      {m.coat.factor > 0.0f, "clearcoat"},
      {m.diffuse_transmission.used(), "diffuse_transmission"},
      {m.volume.dispersion > 0.0f, "dispersion"},
      {m.emissive_strength != usual.emissive_strength, "emissive_strength"},
      {m.ior != usual.ior, "ior"},
      {m.film.used(), "iridescence"},
      {m.sheen.used(), "sheen"},
      {m.specular != usual.specular || m.specular_color != usual.specular_color ||
           m.specular_texture.used() || m.specular_color_texture.used(),
       "specular"},
      {m.transmission > 0.0f, "transmission"},
      {m.unlit, "unlit"},
      {m.volume.thickness > 0.0f, "volume"},
  };
  std::vector<std::string> names;
  for (const Asked& asked : all)
    if (asked.used) names.push_back(std::string("KHR_materials_") + asked.name);
  return names;
}

std::string outline_panel(Controls& controls, Previewer& previewer, OutlineChoice& choice,
                          std::optional<glm::ivec2> picked) {
  if (!previewer.scene()) return {};
  follow(previewer, choice, picked);
  if (!controls.section("Objects", false)) return {};
  const World& world = previewer.scene()->world();
  const std::string said = buttons(controls, previewer, choice);
  const std::size_t hidden = previewer.scene().hidden().size();
  controls.row("Objects",
               hidden > 0 ? fmt::format("{}, and {} hidden", world.parts.size(), hidden)
                          : fmt::format("{}", world.parts.size()),
               "Visible objects, one material each.");
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##find object", "Find an object", &choice.find);
  controls.placed("Find object", "List only objects whose names contain these letters.",
                  Controls::Use::edits);
  tree(controls, previewer.scene()->world(), choice);
  return said;
}

}  // namespace asos
