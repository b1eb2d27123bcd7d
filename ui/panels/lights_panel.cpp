#include "ui/new_lights.h"
#include "ui/panels/light_editor.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

namespace asos {

namespace {

constexpr float most_lights_shown = 6.5f;  // before the list scrolls; the half one says so

/// A row a light: on or off, its name and its kind.
void light_list(Controls& controls, SceneEdits& edits, LightChoice& choice) {
  const std::vector<EditedLight>& lights = edits.lights();
  const float line = ImGui::GetFrameHeightWithSpacing();
  const float rows = std::min(static_cast<float>(lights.size()), most_lights_shown);
  ImGui::BeginChild("lights", {0.0f, rows * line});
  for (std::size_t i = 0; i < lights.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string number = std::to_string(i + 1);
    bool on = lights[i].on;
    if (ImGui::Checkbox("##on", &on)) edits.edit_lights()[i].on = on;
    controls.placed("Light on/" + number, "Whether the light shines.", Controls::Use::edits);
    ImGui::SameLine();
    const std::string& own_name = lights[i].light.name;
    const std::string name = own_name.empty() ? "light " + number : own_name;
    ImGui::AlignTextToFramePadding();
    const bool selected = choice.selected == static_cast<int>(i);
    ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyle().Colors[ImGuiCol_SliderGrab]);
    const bool pressed = ImGui::Selectable(name.c_str(), selected);
    ImGui::PopStyleColor();
    if (pressed) choice.selected = selected ? -1 : static_cast<int>(i);
    controls.placed("Light/" + number,
                    lights[i].light.own_part >= 0
                        ? "Stands for a surface that shines. Click to edit it, and again to be "
                          "done; the surface itself looks as before."
                        : "Click to edit this light, and again to be done.",
                    Controls::Use::edits);
    const char* kind = light_kind_name(kind_of(lights[i].light));
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(kind).x);
    ImGui::TextDisabled("%s", kind);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void add(SceneEdits& edits, LightChoice& choice, Light light) {
  edits.edit_lights().push_back(EditedLight::of(std::move(light)));
  choice.selected = static_cast<int>(edits.lights().size()) - 1;
}

/// Shines as bright as makes a white surface beside it half white.
void add_face(Previewer& previewer, LightChoice& choice, std::optional<glm::ivec2> picked) {
  choice.error.clear();
  if (!picked) {
    choice.error = "Click a surface in the picture first.";
    return;
  }
  if (!previewer.scene()->geometry->boundaries.known()) {
    choice.error = "The boundaries of surfaces are still being looked for.";
    return;
  }
  const Hit hit = previewer.viewpoint().seen_at(picked->x + 0.5, picked->y + 0.5);
  const std::size_t triangles = previewer.scene()->world().triangles.size();
  if (!hit.valid() || hit.triangle >= triangles) {
    choice.error = "There is no flat surface at the pixel that was clicked.";
    return;
  }
  std::optional<Light> light =
      light_on_face(*previewer.scene(), hit.triangle, previewer.viewpoint().camera().eye());
  if (!light) {
    choice.error = "The surface that was clicked has no flat piece.";
    return;
  }
  add(previewer.edits(), choice, std::move(*light));
}

void buttons(Controls& controls, Previewer& previewer, LightChoice& choice,
             std::optional<glm::ivec2> picked) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  const bool any_selected = choice.selected >= 0;
  if (controls.button("Add light",
                      "Add a ball between the viewer and the middle of what the camera circles.",
                      any_selected ? width : -1.0f)) {
    const SceneSize size = SceneSize::of(previewer.scene()->world().bounds);
    const OrbitCamera& camera = previewer.viewpoint().camera();
    add(previewer.edits(), choice, new_light(camera.eye(), camera.pivot(), size.radius));
  }
  if (any_selected) ImGui::SameLine();
  if (any_selected &&
      controls.button("Remove light", "Remove the selected light. Ctrl+Z brings it back.", width)) {
    std::vector<EditedLight>& lights = previewer.edits().edit_lights();
    lights.erase(lights.begin() + choice.selected);
    choice.selected = std::min(choice.selected, static_cast<int>(lights.size()) - 1);
  }
  if (controls.button("Face to light",
                      "Turn the flat piece of surface that was clicked in the picture into a light "
                      "of that outline. The surface itself looks as before.",
                      width))
    add_face(previewer, choice, picked);
  ImGui::SameLine();
  if (controls.button("Reset lights", "Back to the lights that the scene came with.", width)) {
    previewer.edits().reset_lights();
    choice.selected = -1;
  }
  if (choice.error.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::warning));
  ImGui::TextWrapped("%s", choice.error.c_str());
  ImGui::PopStyleColor();
  controls.placed("Light error", nullptr);
}

}  // namespace

void lights_panel(Controls& controls, Previewer& previewer, LightChoice& choice,
                  std::optional<glm::ivec2> picked) {
  if (!previewer.scene() || !controls.section("Lights")) return;
  SceneEdits& edits = previewer.edits();
  const int count = static_cast<int>(edits.lights().size());
  choice.selected = std::min(choice.selected, count - 1);
  if (count > 0) light_list(controls, edits, choice);
  buttons(controls, previewer, choice, picked);
  if (choice.selected < 0 || choice.selected >= static_cast<int>(edits.lights().size())) return;

  ImGui::Spacing();
  const auto index = static_cast<std::size_t>(choice.selected);
  EditedLight edited = edits.lights()[index];
  const World& world = previewer.scene()->world();
  const SceneSize size = SceneSize::of(world.bounds);
  if (edit_light(controls, edited, size, world.origin))
    edits.edit_lights()[index] = std::move(edited);
  controls.checkbox("Marks",
                    "Show the lights in the picture: the selected one with its outline. Drag its "
                    "mark to move it along the picture; click another's to select that.",
                    choice.show_marks, true);
}

}  // namespace asos
