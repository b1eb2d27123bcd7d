#include "renderer/files/counted.h"
#include "ui/new_lights.h"
#include "ui/panels/inner_list.h"
#include "ui/panels/light_editor.h"
#include "ui/panels/named_like.h"
#include "ui/panels/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

constexpr float most_lights_shown = 6.5f;  // half a row shows that the list scrolls

/// Centre and half height of the visible area at the camera's pivot.
SceneSize looked_at(const Viewpoint& viewpoint) {
  const OrbitCamera& camera = viewpoint.camera();
  const Camera lens = camera.camera();
  const double half_height = lens.type == Camera::Type::perspective
                                 ? camera.distance() * std::tan(0.5 * lens.fov_y_rad)
                                 : 0.5 * lens.height;
  return {camera.pivot(), half_height > 0.0 ? half_height : 1.0};
}

constexpr std::size_t many_lights = 12;  // from this number on the list has a filter

std::string name_of(const EditedLight& edited, std::size_t index) {
  const std::string& own = edited.light.name;
  return own.empty() ? "light " + std::to_string(index + 1) : own;
}

/// The lights of the faces of one emissive surface, or a single light.
struct LightGroup {
  std::size_t first = 0, count = 1;
};

/// Groups in the list's order. Only lights from the scene are grouped; edited lights keep their
/// place.
std::vector<LightGroup> groups_of(const std::vector<EditedLight>& lights) {
  std::vector<LightGroup> groups;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool joins = i > 0 && lights[i].light.own_part >= 0 &&
                       lights[i].light.own_part == lights[i - 1].light.own_part;
    if (joins) {
      ++groups.back().count;
    } else {
      groups.push_back({i, 1});
    }
  }
  return groups;
}

// Dimmed text cannot be read on the colour of a selected row.
void right_aligned(const std::string& text, bool selected) {
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
  const ImGuiCol colour = selected ? ImGuiCol_Text : ImGuiCol_TextDisabled;
  ImGui::TextColored(ImGui::GetStyle().Colors[colour], "%s", text.c_str());
}

/// A row with a light's switch, name and kind.
void light_row(Controls& controls, SceneEdits& edits, LightChoice& choice, std::size_t i) {
  const EditedLight& edited = edits.lights()[i];
  ImGui::PushID(static_cast<int>(i));
  const std::string number = std::to_string(i + 1), name = name_of(edited, i);
  const char* kind = row_of(edited.light).name;
  bool on = edited.on;
  const bool stands_for_surface = edited.light.own_part >= 0;
  if (ImGui::Checkbox("##on", &on)) edits.edit_lights()[i].on = on;
  controls.placed("Light on/" + number, "Turn the light on or off.", Controls::Use::edits);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const bool selected = choice.selected == static_cast<int>(i);
  // A selected row keeps its colour while hovered.
  const ImVec4* colours = ImGui::GetStyle().Colors;
  const ImVec4 marked = colours[ImGuiCol_SliderGrab];
  ImGui::PushStyleColor(ImGuiCol_Header, marked);
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered,
                        selected ? marked : colours[ImGuiCol_HeaderHovered]);
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, selected ? marked : colours[ImGuiCol_HeaderActive]);
  const bool pressed = ImGui::Selectable(name.c_str(), selected);
  ImGui::PopStyleColor(3);
  if (pressed) choice.selected = selected ? -1 : static_cast<int>(i);
  controls.placed("Light/" + number,
                  stands_for_surface ? "Light of an emissive surface. Click to edit; click again "
                                       "to close. The surface keeps its look."
                                     : "Click to edit this light; click again to close.",
                  Controls::Use::edits);
  right_aligned(kind, selected);
  ImGui::PopID();
}

/// One switch for all lights of a surface, which can be unfolded below it.
void group_row(Controls& controls, SceneEdits& edits, LightChoice& choice,
               const LightGroup& group) {
  ImGui::PushID(static_cast<int>(group.first));
  const auto of_group = [&](const std::vector<EditedLight>& lights) {
    return std::span(lights).subspan(group.first, group.count);
  };
  const auto shining = of_group(edits.lights());
  bool on = std::any_of(shining.begin(), shining.end(), [](const auto& light) { return light.on; });
  const std::string number = std::to_string(group.first + 1);
  const std::string name = name_of(edits.lights()[group.first], group.first);
  if (ImGui::Checkbox("##all", &on)) {
    std::vector<EditedLight>& lights = edits.edit_lights();
    for (std::size_t i = 0; i < group.count; ++i) lights[group.first + i].on = on;
  }
  controls.placed("Surface on/" + number, "Turn all lights of the surface on or off.",
                  Controls::Use::edits);
  ImGui::SameLine();
  const bool open = ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen);
  controls.placed("Surface/" + number, "Emissive surface with several lights. Click to list them.",
                  Controls::Use::edits);
  right_aligned(counted(group.count, "light"), false);
  ImGui::PopID();
  if (!open) return;
  ImGui::Indent();
  for (std::size_t i = 0; i < group.count; ++i) light_row(controls, edits, choice, group.first + i);
  ImGui::Unindent();
}

void light_list(Controls& controls, SceneEdits& edits, LightChoice& choice) {
  if (edits.lights().size() >= many_lights) {
    controls.text_field("Find light", "List only lights whose names contain these letters.",
                        "Filter lights", choice.find);
  } else {
    choice.find.clear();
  }
  const std::vector<LightGroup> groups = groups_of(edits.lights());
  const float line = ImGui::GetFrameHeightWithSpacing();
  // A list with groups has its full height from the start, and scrolls when a group is unfolded.
  const float rows = groups.size() < edits.lights().size()
                         ? most_lights_shown
                         : std::min(static_cast<float>(groups.size()), most_lights_shown);
  const InnerList list("lights", {0.0f, rows * line});
  for (const LightGroup& group : groups) {
    if (!named_like(name_of(edits.lights()[group.first], group.first), choice.find)) continue;
    if (group.count > 1) {
      group_row(controls, edits, choice, group);
    } else {
      light_row(controls, edits, choice, group.first);
    }
  }
}

void add(SceneEdits& edits, LightChoice& choice, Light light) {
  edits.edit_lights().push_back(EditedLight::of(std::move(light)));
  choice.selected = static_cast<int>(edits.lights().size()) - 1;
}

/// Adds a light on the clicked face, four times as bright as what is displayed as white. Returns
/// why it could not, or an empty text.
const char* add_face(Previewer& previewer, LightChoice& choice, const PointedAt& at) {
  constexpr float times_white = 4.0f;
  const std::optional<glm::ivec2> picked = at.pixel;
  if (!picked) return "Click a surface in the picture first.";
  if (!previewer.scene()->geometry->boundaries.known_or_started())
    return "Edges are still being searched.";
  const Hit hit = previewer.viewpoint().seen_at(picked->x + 0.5, picked->y + 0.5);
  const std::size_t triangles = previewer.scene()->world().triangles.size();
  if (!hit.valid() || hit.triangle >= triangles) return "The clicked pixel shows no flat surface.";
  std::optional<Light> light =
      light_on_face(*previewer.scene(), hit.triangle, previewer.viewpoint().camera().eye());
  if (!light) return "The clicked surface has no flat face.";
  light->intensity *= times_white * std::exp2(-at.exposure_ev);
  add(previewer.edits(), choice, std::move(*light));
  return "";
}

/// Buttons are above the list, so that a growing list does not move them.
void buttons(Controls& controls, Previewer& previewer, LightChoice& choice, const PointedAt& at) {
  const float width = Controls::button_width(2);
  if (controls.button("Add light", "Add a sphere light between camera and orbit centre.", width)) {
    const SceneSize size = SceneSize::of(previewer.scene()->world().bounds);
    const OrbitCamera& camera = previewer.viewpoint().camera();
    add(previewer.edits(), choice, new_light(camera.eye(), camera.pivot(), size.radius));
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(choice.selected < 0);
  if (controls.button("Remove light", "Remove the selected light (undo: Ctrl+Z).", width)) {
    std::vector<EditedLight>& lights = previewer.edits().edit_lights();
    lights.erase(lights.begin() + choice.selected);
    choice.selected = std::min(choice.selected, static_cast<int>(lights.size()) - 1);
  }
  ImGui::EndDisabled();
  if (controls.button("Light from face", "Make an area light from the face you clicked.", -1.0f))
    choice.error = add_face(previewer, choice, at);
}

}  // namespace

void lights_panel(Controls& controls, Previewer& previewer, LightChoice& choice,
                  const PointedAt& at) {
  if (!previewer.scene() || !controls.section("Lights")) return;
  SceneEdits& edits = previewer.edits();
  const int count = static_cast<int>(edits.lights().size());
  choice.selected = std::min(choice.selected, count - 1);
  buttons(controls, previewer, choice, at);
  if (!edits.lights().empty()) light_list(controls, edits, choice);
  controls.warning("Light error", choice.error);
  if (choice.selected < 0 || choice.selected >= static_cast<int>(edits.lights().size())) return;

  ImGui::Spacing();
  const auto index = static_cast<std::size_t>(choice.selected);
  EditedLight edited = edits.lights()[index];
  const World& world = previewer.scene()->world();
  if (edit_light(controls, edited,
                 {SceneSize::of(world.bounds), looked_at(previewer.viewpoint()), world.origin,
                  choice.keep_power}))
    edits.edit_lights()[index] = std::move(edited);
  if (area_of(edits.lights()[index].light) > 0.0)
    controls.checkbox("Keep total power",
                      "A larger light gets darker, so that the scene stays as bright.",
                      choice.keep_power, true);
  controls.checkbox(
      "Show gizmos",
      "Show lights in the picture. Drag a gizmo to move the light; click one to select it.",
      choice.show_marks, true);
}

}  // namespace asos::ui
