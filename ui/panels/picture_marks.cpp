#include "renderer/geometry/pixel_rect.h"
#include "ui/panels/check_panel.h"
#include "ui/panels/grid_overlay.h"
#include "ui/panels/overlays.h"
#include "ui/panels/projection.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace asos::ui {

// Marks over the picture: the effect of MAX, the part that is refined first, and a scale.

namespace {

constexpr std::uint32_t ended_rgb = 0xffc800;
constexpr int fraction_of_side = 4;  // the part is this fraction of the picture's shorter side

}  // namespace

ImVec2 place_of(glm::vec2 pixel, const PictureView& view, const PictureArea& area) {
  const glm::vec2 at = area.rect.lo + (view.offset() + pixel * view.scale()) / area.scale;
  return {at.x, at.y};
}

void max_marks(const MaxEffect& effect, const PictureView& view, const PictureArea& area) {
  if (view.scale() <= 0.0f) return;
  draw_runs(effect.ended, ended_rgb, view, area);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize(), radius = 0.9f * em;
  for (const glm::ivec2 pixel : effect.worst) {
    const ImVec2 at = place_of(glm::vec2(pixel) + 0.5f, view, area);
    draw.AddCircle(at, radius, theme::packed(0x000000), 0, 0.3f * em);
    draw.AddCircle(at, radius, theme::packed(0xffffff), 0, 0.12f * em);
  }
}

namespace {

// glTF files are in metres; other formats have no unit.
bool in_metres(const std::string& source) {
  const std::string extension = std::filesystem::path(source).extension().string();
  return extension == ".gltf" || extension == ".glb";
}

std::string length_words(double metres) {
  if (metres < 0.01) return fmt::format("{:.6g} mm", 1000.0 * metres);
  if (metres < 1.0) return fmt::format("{:.6g} cm", 100.0 * metres);
  return metres < 1000.0 ? fmt::format("{:.6g} m", metres)
                         : fmt::format("{:.6g} km", metres / 1000.0);
}

}  // namespace

void scale_bar(Controls& controls, const Previewer& previewer, const PictureView& view,
               const PictureArea& area) {
  constexpr float least_width_em = 40.0f, least_height_em = 16.0f, least_bar_em = 5.0f;
  const float em = ImGui::GetFontSize();
  const WindowRect& rect = area.rect;
  const Film& film = previewer.render().film();
  if (rect.size.x < least_width_em * em || rect.size.y < least_height_em * em || film.width <= 0 ||
      !previewer.scene() || !in_metres(previewer.scene()->geometry->source))
    return;
  const Projection on(previewer.viewpoint(), film, view, area);
  const glm::dvec3 pivot = previewer.viewpoint().camera().pivot();
  const double metres_per_unit = glm::length(on.moved(pivot, {1.0f, 0.0f}));
  const double length = grid_step(5.0 * static_cast<double>(least_bar_em * em) * metres_per_unit);
  if (!(length > 0.0)) return;
  const std::string words = length_words(length);
  const float width = static_cast<float>(length / metres_per_unit);
  const ImVec2 text = ImGui::CalcTextSize(words.c_str());
  const ImVec2 hi{rect.lo.x + rect.size.x - em, rect.lo.y + rect.size.y - em};
  const ImVec2 lo{hi.x - width, hi.y - text.y - 0.6f * em};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({lo.x - 0.4f * em, lo.y - 0.2f * em}, {hi.x + 0.4f * em, hi.y + 0.4f * em},
                     theme::packed(theme::panel, 0.8f), 0.25f * em);
  draw.AddText({std::round(0.5f * (lo.x + hi.x - text.x)), lo.y}, theme::packed(theme::text),
               words.c_str());
  const std::uint32_t colour = theme::packed(theme::text);
  draw.AddLine({lo.x, hi.y}, hi, colour, 1.5f);
  for (const float x : {lo.x, hi.x}) draw.AddLine({x, hi.y - 0.4f * em}, {x, hi.y}, colour, 1.5f);
  ImGui::SetCursorScreenPos(lo);
  ImGui::Dummy({width, hi.y - lo.y});
  controls.placed_words("Scale", words,
                        "Length at the distance of the point that the camera orbits.");
}

void first_part_mark(Controls& controls, PreviewRender& render, const PictureView& view,
                     const PictureArea& area) {
  const PixelRect part = render.preferred();
  if (part.empty() || view.scale() <= 0.0f) return;
  const ImVec2 lo = place_of({part.x, part.y}, view, area);
  const ImVec2 hi = place_of({part.x + part.width, part.y + part.height}, view, area);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize();
  draw.AddRect(lo, hi, theme::packed(0x000000), 0.0f, 0, 0.25f * em);
  draw.AddRect(lo, hi, theme::packed(0xffffff), 0.0f, 0, 0.1f * em);
  const glm::vec2 end = area.rect.lo + area.rect.size - glm::vec2(11.0f, 2.2f) * em;
  ImGui::SetCursorScreenPos({std::clamp(lo.x, area.rect.lo.x, std::max(area.rect.lo.x, end.x)),
                             std::clamp(hi.y, area.rect.lo.y, std::max(area.rect.lo.y, end.y))});
  if (controls.button("Refined first: end", "Refine the whole picture again (Z)."))
    render.prefer({});
}

void refine_here_first(UiState& state, PreviewRender& render) {
  if (!render.preferred().empty()) {
    render.prefer({});
    state.said = "Refining the whole picture";
    return;
  }
  const Film& film = render.film();
  if (!state.hovered) {
    state.said = "Point at the part to refine first";
    return;
  }
  const int side = std::max(1, std::min(film.width, film.height) / fraction_of_side);
  const glm::ivec2 lo = *state.hovered - side / 2;
  render.prefer(intersection({lo.x, lo.y, side, side}, {0, 0, film.width, film.height}));
  state.said = "Refined first: this part. Hold Z and drag for another";
}

}  // namespace asos::ui
