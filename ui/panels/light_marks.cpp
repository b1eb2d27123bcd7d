#include "renderer/lights/lights_without_geometry.h"
#include "ui/panels/overlays.h"
#include "ui/panels/projection.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

// Marks have the same colours in both themes, because pictures do not depend on the theme.
std::uint32_t over_picture(theme::Colour colour) {
  return theme::rgb(theme::Look::dark, colour);
}

constexpr float mark_radius_em = 0.4f;
constexpr std::size_t most_marks = 64;

using Outline = std::vector<glm::dvec3>;

/// A light's shape as closed outlines; for a ball or tube, its silhouette, or none from inside.
std::vector<Outline> outlines_of(const Light& light, const Camera& camera) {
  if (!light.outlines.empty()) return light.outlines;
  const glm::dvec3 eye(camera.world_from_camera[3]), back(camera.world_from_camera[2]);
  const bool perspective = camera.type == Camera::Type::perspective;
  std::vector<Outline> outlines =
      light_outlines(prepare_light(light), perspective ? std::optional(eye) : std::nullopt, -back);
  if (outlines.empty() && light.half_u != glm::dvec3(0.0))
    outlines.push_back({light.position - light.half_u, light.position + light.half_u});
  return outlines;
}

/// Draws the outline and, for lights with a direction, a line along it of constant length on the
/// screen.
void draw_outline(const Projection& projection, const Light& light, const Camera& camera) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::uint32_t colour = theme::packed(over_picture(theme::warning));
  for (const Outline& outline : outlines_of(light, camera)) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      projection.line(draw, outline[i], outline[(i + 1) % outline.size()], colour);
  }
  const glm::dvec3 eye(camera.world_from_camera[3]);
  const double stroke = camera.type == Camera::Type::perspective
                            ? 0.1 * glm::distance(light.position, eye)
                            : 0.1 * camera.height;
  if (has_direction(light))
    projection.line(draw, light.position, light.position + stroke * light.direction, colour);
}

/// Draws an arrow at the picture's border towards a light outside it; a click selects the light.
void border_arrow(Controls& controls, LightChoice& choice, const Projection& projection,
                  glm::dvec3 h, std::size_t index) {
  const float r = mark_radius_em * ImGui::GetFontSize();
  const ImVec2 lo = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const glm::vec2 centre(lo.x + 0.5f * size.x, lo.y + 0.5f * size.y);
  const glm::vec2 room = 0.5f * glm::vec2(size.x, size.y) - 2.0f * r;
  if (room.x <= 0.0f || room.y <= 0.0f) return;
  // A light behind the viewer is projected to the opposite side.
  const bool before = projection.visible(h);
  if (h.z == 0.0) h.z = -1e-9;
  const ImVec2 at = projection.window(h);
  const glm::vec2 way = (before ? 1.0f : -1.0f) * (glm::vec2(at.x, at.y) - centre);
  if (!(glm::length(way) > 0.0f) || !std::isfinite(glm::length(way))) return;
  const glm::vec2 place =
      centre + way * std::min(room.x / std::max(std::abs(way.x), 1e-6f * room.x),
                              room.y / std::max(std::abs(way.y), 1e-6f * room.y));
  const bool selected = choice.selected == static_cast<int>(index);
  ImGui::SetCursorScreenPos({place.x - 1.5f * r, place.y - 1.5f * r});
  ImGui::PushID(static_cast<int>(index));
  if (ImGui::InvisibleButton("light arrow", {3.0f * r, 3.0f * r}))
    choice.selected = static_cast<int>(index);
  ImGui::PopID();
  controls.placed("Light arrow/" + std::to_string(index + 1),
                  "This light is outside the picture. Click to select it.", Controls::Use::edits);
  const bool lit = selected || ImGui::IsItemHovered();
  const glm::vec2 ahead = glm::normalize(way), aside(-ahead.y, ahead.x);
  const auto corner = [&](float along, float across) {
    const glm::vec2 p = place + r * (along * ahead + across * aside);
    return ImVec2{p.x, p.y};
  };
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled({place.x, place.y}, 1.4f * r, theme::packed(theme::plot_ground, 0.8f));
  // Slender, since an equilateral triangle points in three directions.
  draw.AddTriangleFilled(corner(1.3f, 0.0f), corner(-0.8f, 0.6f), corner(-0.8f, -0.6f),
                         theme::packed(over_picture(lit ? theme::warning : theme::dim_text)));
}

/// Draws a light's mark: a click selects the light, a drag moves it. Outside the picture an arrow
/// replaces it.
void mark(Controls& controls, SceneEdits& edits, LightChoice& choice, const Projection& projection,
          std::size_t index) {
  const EditedLight& edited = edits.lights()[index];
  const glm::dvec3 h = projection.homogeneous(edited.light.position);
  const ImVec2 at = projection.visible(h) ? projection.window(h) : ImVec2{-1e9f, -1e9f};
  const float r = mark_radius_em * ImGui::GetFontSize();
  const ImVec2 lo = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (!(at.x > lo.x + r && at.y > lo.y + r && at.x < lo.x + size.x - r && at.y < lo.y + size.y - r))
    return border_arrow(controls, choice, projection, h, index);
  const bool selected = choice.selected == static_cast<int>(index);
  ImGui::SetCursorScreenPos({at.x - 1.5f * r, at.y - 1.5f * r});
  ImGui::PushID(static_cast<int>(index));
  ImGui::InvisibleButton("light mark", {3.0f * r, 3.0f * r});
  ImGui::PopID();
  controls.placed("Mark/" + std::to_string(index + 1),
                  selected ? "Drag to move the light." : "Click to select this light.",
                  Controls::Use::edits);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  draw.AddCircleFilled(at, r, theme::packed(theme::plot_ground, 0.8f));
  draw.AddCircleFilled(
      at, 0.7f * r,
      theme::packed(over_picture(selected || lit ? theme::warning : theme::dim_text),
                    edited.on ? 1.0f : 0.35f));
  if (ImGui::IsItemActivated()) choice.selected = static_cast<int>(index);
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (!ImGui::IsItemActive() || (by.x == 0.0f && by.y == 0.0f)) return;
  const glm::dvec3 way = projection.moved(edited.light.position, {by.x, by.y});
  move_light(edits.edit_lights()[index].light, way);
}

}  // namespace

void light_marks(Controls& controls, Previewer& previewer, LightChoice& choice,
                 const PictureView& view, const PictureArea& area) {
  const Film& film = previewer.render().film();
  if (!choice.show_marks || choice.selected < 0 || !previewer.scene() || view.scale() <= 0.0f ||
      film.width <= 0)
    return;
  const std::vector<EditedLight>& lights = previewer.edits().lights();
  if (lights.empty()) return;
  const Projection projection(previewer.viewpoint(), film, view, area);
  const auto chosen = static_cast<std::size_t>(choice.selected);
  if (chosen < lights.size() && has_position(lights[chosen].light))
    draw_outline(projection, lights[chosen].light, previewer.viewpoint().camera().camera());
  for (std::size_t i = 0; i < std::min(lights.size(), most_marks); ++i) {
    if (has_position(lights[i].light)) mark(controls, previewer.edits(), choice, projection, i);
  }
}

namespace {

// Draws text on its own background, because the picture may have any colour. `align` 1: the text
// ends at `at`.
void side_label(const std::string& text, glm::vec2 at, float align) {
  const float em = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 lo{std::round(at.x - align * size.x), at.y + 0.5f * em};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({lo.x - 0.35f * em, lo.y - 0.15f * em},
                     {lo.x + size.x + 0.35f * em, lo.y + size.y + 0.15f * em},
                     theme::packed(theme::panel, 0.8f), 0.25f * em);
  draw.AddText(lo, theme::packed(theme::text), text.c_str());
}

}  // namespace

void wipe_line(Controls& controls, Frames& frames, const PictureView& view,
               const Previewer& previewer, const PictureArea& area) {
  const Film& film = previewer.render().film();
  const float width = view.scale() * static_cast<float>(film.width) / area.scale;
  if (frames.comparison != Comparison::wipe || !frames.compared() || width <= 0.0f) return;
  const float left = area.rect.lo.x + view.offset().x / area.scale;
  const float x = left + frames.wipe * width;
  const float grip = 0.4f * ImGui::GetFontSize();
  const float top = area.rect.lo.y, bottom = area.rect.lo.y + area.rect.size.y;
  ImGui::SetCursorScreenPos({x - grip, top});
  ImGui::InvisibleButton("wipe", {2.0f * grip, bottom - top});
  controls.placed("Wipe line", "Drag the divider.", Controls::Use::edits);
  const bool held = ImGui::IsItemActive();
  if (held) frames.wipe = std::clamp((ImGui::GetIO().MousePos.x - left) / width, 0.0f, 1.0f);
  const bool lit = held || ImGui::IsItemHovered();
  ImGui::GetWindowDrawList()->AddLine(
      {x, top}, {x, bottom}, theme::packed(lit ? over_picture(theme::accent_bright) : 0xffffff),
      1.5f);
  side_label(picture_words(previewer.render()), {x - 1.5f * grip, top}, 1.0f);
  side_label(frames.compared_title(), {x + 1.5f * grip, top}, 0.0f);
}

}  // namespace asos::ui
