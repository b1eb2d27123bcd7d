#include "renderer/comparison/method.h"
#include "renderer/film/split_map.h"
#include "renderer/study/measures.h"
#include "ui/panels/inner_list.h"
#include "ui/panels/overlay_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/pixel_place.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace asos::ui {

namespace {

std::uint32_t kind_colour(FeatureKind kind) {
  SplitCause cause = SplitCause::outline;
  if (kind == FeatureKind::crease || kind == FeatureKind::seam) cause = SplitCause::crease;
  if (kind == FeatureKind::intersection) cause = SplitCause::intersection;
  return theme::packed(split_cause_colour(cause));
}

std::uint32_t shown_colour(glm::vec3 radiance, bool unlit, const DisplayTransform& display) {
  return theme::packed(display_bytes(radiance, unlit ? DisplayTransform{} : display));
}

std::string number(float value) {
  return number_words(static_cast<double>(value));
}

std::string colour_words(glm::vec3 c) {
  return number(c.x) + "  " + number(c.y) + "  " + number(c.z);
}

void values(Controls& controls, const Film& film, const Frames& frames,
            const DisplaySettings& display, glm::ivec2 pixel) {
  const std::size_t i = film.index(pixel.x, pixel.y);
  const glm::vec3 radiance = film.radiance[i];
  const glm::u8vec3 bytes = display_bytes(film, i, display.transform());
  controls.row("Linear", colour_words(radiance),
               "Linear red, green and blue; 1 is white at exposure 0.");
  controls.row("8-bit", fmt::format("{} {} {}", bytes.x, bytes.y, bytes.z),
               "Display values, 0 to 255.");
  for (std::size_t k = 0; k < frames.stored.size(); ++k) {
    const StoredFrame& frame = frames.stored[k];
    const std::string name = fmt::format("vs. snapshot {}", k + 1);
    if (pixel.x >= frame.film.width || pixel.y >= frame.film.height ||
        frame.film.width != film.width || frame.film.height != film.height) {
      controls.row(name.c_str(), "another size", "The snapshot has another size.");
      continue;
    }
    const glm::vec3 d = radiance - frame.film.radiance[i];
    controls.row(name.c_str(), fmt::format("{:+.5f} {:+.5f} {:+.5f}", d.x, d.y, d.z),
                 "Linear difference from the snapshot.");
  }
}

/// Level and cause as in the split map, and why the splitting stopped. A pixel with motion blur has
/// many traces; `report` is of the middle moment.
void why(Controls& controls, const PixelReport& report, const Film& film, glm::ivec2 pixel) {
  const std::size_t i = film.index(pixel.x, pixel.y);
  const bool moves = film.cause[i] == SplitCause::motion;
  const SplitCause cause = moves ? SplitCause::motion : report.trace.cause;
  if (cause != SplitCause::none) {
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 lo{at.x, at.y + 0.15f * em}, hi{at.x + 0.8f * em, at.y + 0.95f * em};
    ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, theme::packed(split_cause_colour(cause)));
    ImGui::GetWindowDrawList()->AddRect(lo, hi, theme::packed(theme::dim_text));
    ImGui::Dummy({0.8f * em, em});
    ImGui::SameLine();
    const std::string words = moves ? split_words(film, i) : report.split();
    ImGui::TextWrapped("%s", words.c_str());
    controls.placed_words("Why", words, words_of(cause));
  }
  const std::string verdict =
      moves ? "The mean of many moments. The cells show the middle one." : report.verdict();
  ImGui::TextWrapped("%s", verdict.c_str());
  controls.placed_words("Verdict", verdict, nullptr);
}

void cost_rows(Controls& controls, const Film& film, const SplitFindings* findings,
               glm::ivec2 pixel) {
  const std::size_t i = film.index(pixel.x, pixel.y);
  if (film.rays[i] > 0.0f) {
    controls.row("Rays",
                 fmt::format("{:.0f} in {:.4g} \u00b5s", film.rays[i],
                             1e6 * static_cast<double>(film.seconds[i])),
                 "Rays of the pixel, and its CPU time within its block.");
  }
  if (!findings || findings->reference->width != film.width ||
      findings->reference->height != film.height)
    return;
  const glm::vec3 d(clipped_difference(film.radiance[i], findings->reference->radiance[i]));
  controls.row("Error", fmt::format("{:+.5f} {:+.5f} {:+.5f}", d.x, d.y, d.z),
               "Difference from the reference of \"Compare\", clipped linear values.");
}

/// The pixel's enlarged square on the screen.
struct PixelCanvas {
  ImVec2 corner;
  float side;

  [[nodiscard]] ImVec2 at(glm::vec2 place) const {
    return {corner.x + place.x * side, corner.y + place.y * side};
  }
};

/// The pyray that is drawn: the pixel itself, or a shadow or mirror pyray that one of its leaves
/// started.
struct ShownPyray {
  const std::vector<TracedCell>& cells;
  const std::vector<SeenPart>& seen;
  DisplayTransform display;
  int deepest = 1000;                    ///< deepest level of cells to draw
  const std::set<std::uint32_t>& unlit;  ///< triangles that are displayed as they are
};

// Draws without antialiasing, which would show gaps between adjacent parts.
void draw_seen(ImDrawList& draw, const PixelCanvas& canvas, const ShownPyray& shown) {
  const ImDrawListFlags smooth = std::exchange(draw.Flags, ImDrawListFlags_None);
  for (const SeenPart& part : shown.seen) {
    std::array<ImVec2, 4> corners{};
    std::transform(part.corners.begin(), part.corners.end(), corners.begin(),
                   [&](glm::vec2 corner) { return canvas.at(corner); });
    draw.AddConvexPolyFilled(
        corners.data(), static_cast<int>(corners.size()),
        shown_colour(part.radiance, shown.unlit.contains(part.triangle), shown.display));
  }
  draw.Flags = smooth;
}

void draw_cells(ImDrawList& draw, const PixelCanvas& canvas, const ShownPyray& shown) {
  for (const TracedCell& cell : shown.cells) {
    if (cell.level > shown.deepest) continue;
    const bool undecided = cell.fate == CellFate::finest || cell.fate == CellFate::stopped ||
                           cell.fate == CellFate::saturated;
    draw.AddRect(canvas.at(cell.corner), canvas.at(cell.corner + cell.side),
                 undecided ? theme::packed(theme::alarm) : IM_COL32(128, 128, 128, 150));
  }
  for (const TracedCell& cell : shown.cells) {
    // Edges of a split cell are drawn by its children.
    const bool is_split = cell.fate == CellFate::split || cell.fate == CellFate::uneven;
    if (cell.level > shown.deepest || (is_split && cell.level < shown.deepest)) continue;
    draw.PushClipRect(canvas.at(cell.corner), canvas.at(cell.corner + cell.side), true);
    for (const TracedBoundary& b : cell.boundaries) {
      draw.AddLine(canvas.at(b.from), canvas.at(b.to), IM_COL32(0, 0, 0, 255), 4.0f);
      draw.AddLine(canvas.at(b.from), canvas.at(b.to), kind_colour(b.kind), 2.0f);
    }
    draw.PopClipRect();
  }
}

void draw_samples(ImDrawList& draw, const PixelCanvas& canvas, const ShownPyray& shown) {
  std::size_t count = 0;
  for (const TracedCell& cell : shown.cells) count += cell.samples.size();
  const float radius = count > 200 ? 2.0f : 3.5f;
  for (const TracedCell& cell : shown.cells) {
    if (cell.level > shown.deepest) continue;
    for (const TracedSample& sample : cell.samples) {
      draw.AddCircleFilled(canvas.at(sample.at), radius + 1.5f, IM_COL32(0, 0, 0, 255), 12);
      draw.AddCircleFilled(canvas.at(sample.at), radius + 0.7f, IM_COL32(255, 255, 255, 255), 12);
      draw.AddCircleFilled(
          canvas.at(sample.at), radius - 0.8f,
          shown_colour(sample.radiance, shown.unlit.contains(sample.triangle), shown.display), 12);
    }
  }
}

void cell_tooltip(const TracedCell& cell) {
  const double area = 100.0 * std::ldexp(1.0, -2 * cell.level);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(
      fmt::format("Cell of level {}: {:.4g} % of the pixel", cell.level, area).c_str());
  ImGui::TextUnformatted(words_of(cell.fate));
  ImGui::TextDisabled("%s", edge_words(cell).c_str());
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, cell.samples.size()); ++i) {
    const TracedSample& sample = cell.samples[i];
    ImGui::TextDisabled("%s", fmt::format("sample {}: {:.4g} %, {}", i + 1, 100.0 * sample.weight,
                                          colour_words(sample.radiance))
                                  .c_str());
  }
  if (cell.samples.size() > most)
    ImGui::TextDisabled("%s", fmt::format("and {} more", cell.samples.size() - most).c_str());
  ImGui::EndTooltip();
}

/// Marks the leaves that started shadow or mirror pyrays of the shown pyray.
void draw_origins(ImDrawList& draw, const PixelCanvas& canvas, const PixelReport& report,
                  int shown) {
  for (const TracedPyray& pyray : report.trace.pyrays) {
    if (pyray.parent != shown) continue;
    const bool mirror = pyray.kind == TracedPyray::Kind::mirror;
    draw.AddCircle(
        canvas.at(pyray.from), mirror ? 8.5f : 6.5f,
        theme::packed(split_cause_colour(mirror ? SplitCause::reflection : SplitCause::shadow)), 16,
        2.0f);
  }
}

// `most_height`: of the panel. The drawing fits into it, below the title.
void tree(Controls& controls, const PixelReport& report, const UiState& state, float most_height) {
  const int shown_pyray = state.picked_pyray;
  const DisplayTransform display = state.display.transform();
  const bool own = shown_pyray < 0;
  const TracedPyray* pyray =
      own ? nullptr : &report.trace.pyrays[static_cast<std::size_t>(shown_pyray)];
  // A light's visibility is not radiance, so the exposure does not apply.
  const bool shadow = pyray && pyray->kind == TracedPyray::Kind::shadow;
  // Reflected unlit surfaces are part of the light of what reflects them.
  static const std::set<std::uint32_t> none;
  const ShownPyray shown{
      own ? report.trace.cells : pyray->cells,
      own ? report.seen : report.pyray_seen[static_cast<std::size_t>(shown_pyray)],
      shadow ? DisplayTransform{} : display, state.shown_level.value_or(1000),
      own ? report.unlit : none};
  const float fits =
      most_height - ImGui::GetFrameHeightWithSpacing() - 2.0f * ImGui::GetStyle().WindowPadding.y;
  const float side = std::max(1.0f, std::min(ImGui::GetContentRegionAvail().x, fits));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const PixelCanvas canvas{corner, side};
  ImGui::InvisibleButton("tree", {side, side});
  controls.placed("Subdivision", nullptr);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_seen(draw, canvas, shown);
  draw_cells(draw, canvas, shown);
  draw_samples(draw, canvas, shown);
  draw_origins(draw, canvas, report, shown_pyray);
  draw.AddRect(corner, {corner.x + side, corner.y + side}, theme::packed(theme::line));
  if (!ImGui::IsItemHovered() || shown.cells.empty()) return;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const glm::vec2 place((pointer.x - corner.x) / side, (pointer.y - corner.y) / side);
  const TracedCell& cell = shown.cells[cell_at(shown.cells, place)];
  draw.AddRect(canvas.at(cell.corner), canvas.at(cell.corner + cell.side),
               theme::packed(theme::accent_bright), 0.0f, 0, 3.0f);
  cell_tooltip(cell);
}

/// Lists the shadow and mirror pyrays of the shown pyray's leaves, to open them.
void pyray_list(Controls& controls, const PixelReport& report, int& shown) {
  if (shown >= 0) {
    ImGui::TextUnformatted(report.pyray_names[static_cast<std::size_t>(shown)].c_str());
    if (controls.button("Back", "Back to the previous view.", -1.0f))
      shown = report.trace.pyrays[static_cast<std::size_t>(shown)].parent;
  }
  std::vector<int> children;
  for (std::size_t i = 0; i < report.trace.pyrays.size(); ++i)
    if (report.trace.pyrays[i].parent == shown) children.push_back(static_cast<int>(i));
  if (children.empty()) return;
  constexpr float most_rows = 5.5f;
  const float rows = std::min(static_cast<float>(children.size()), most_rows);
  ImGui::TextDisabled("Shadow and mirror rays (click to open)");
  const InnerList list("pyrays", {0.0f, rows * ImGui::GetTextLineHeightWithSpacing()});
  for (const int child : children) {
    ImGui::PushID(child);
    if (ImGui::Selectable(report.pyray_names[static_cast<std::size_t>(child)].c_str()))
      shown = child;
    controls.placed("Pyray/" + std::to_string(child + 1),
                    "Show how this ray pyramid was split. White: the light is visible. Percentages "
                    "are weights in the pixel.",
                    Controls::Use::edits);
    ImGui::PopID();
  }
}

/// The papers' table: for each level the object with the largest possible change.
void level_table(Controls& controls, const PixelReport& report) {
  if (report.trace.levels.empty() ||
      !ImGui::BeginTable("levels", 6, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    return;
  for (const char* head : {"K", "M", "in", "out", "L", "object"}) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < report.trace.levels.size(); ++i) {
    const LevelStatistics& level = report.trace.levels[i];
    ObjectStatistics most;
    for (const ObjectStatistics& object : level.objects) {
      if (object.change(level.level) > most.change(level.level)) most = object;
    }
    ImGui::TableNextRow();
    for (const auto count : {static_cast<std::uint32_t>(level.level), level.marginal, most.in,
                             most.out, most.larger()}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(std::to_string(count).c_str());
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(report.level_object[i].c_str());
  }
  ImGui::EndTable();
  controls.placed("Levels",
                  "Table of the papers. K: level. M: cells with edges. in, out: such cells inside "
                  "and outside the object. L: the larger of both.");
}

}  // namespace

void pixel_panel(Controls& controls, const Previewer& previewer, UiState& state,
                 const PixelFacts& facts, const PictureArea& area) {
  const PixelReport* report = facts.report;
  const Film& film = previewer.render().film();
  if (!state.picked || state.picked->x >= film.width || state.picked->y >= film.height) return;
  const float em = ImGui::GetFontSize();
  const std::optional<PixelPlace> place = picked_place(state, area, em);
  if (!place || place->width < 8.0f * em || place->most_height < 6.0f * em) return;
  ImGui::SetNextWindowPos({place->lo.x, place->lo.y});
  ImGui::SetNextWindowSizeConstraints({place->width, 0.0f}, {place->width, place->most_height});
  const OverlayWindow window("pixel", ImGuiWindowFlags_AlwaysAutoResize);
  const glm::ivec2 pixel = *state.picked;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("Pixel {}, {}", pixel.x, pixel.y).c_str());
  constexpr const char* close = "Close inspector";
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(close).x -
                  2.0f * ImGui::GetStyle().FramePadding.x);
  const bool closed = controls.button(close, "Close (Esc).");
  const bool traced = report && !report->trace.cells.empty();
  if (traced && state.picked_pyray >= static_cast<int>(report->trace.pyrays.size()))
    state.picked_pyray = -1;
  // The tour's card is about the drawing, so that it comes first.
  const bool drawing_first = state.tour.card == Tour::Card::split;
  if (traced && drawing_first) tree(controls, *report, state, place->most_height);
  if (!facts.names.object.empty()) {
    controls.row("Object", facts.names.object, "At the pixel's centre.");
    controls.row("Material", facts.names.material, "At the pixel's centre.");
  }
  if (traced) why(controls, *report, film, pixel);
  values(controls, film, state.frames, state.display, pixel);
  cost_rows(controls, film, facts.findings, pixel);
  if (traced) {
    if (!drawing_first) tree(controls, *report, state, place->most_height);
    pyray_list(controls, *report, state.picked_pyray);
    level_table(controls, *report);
    if (!in_object_space(report->settings.method))
      ImGui::TextDisabled("Splitting by ASOS; another method rendered the picture.");
  }
  controls.checkbox("Show edges", "Draw all edges of the view into the picture, hidden ones too.",
                    state.show_boundaries, false);
  if (report && state.show_boundaries && !report->all_boundaries)
    ImGui::TextDisabled(
        "%s", fmt::format("The first {} are shown.", PixelReport::most_boundaries).c_str());
  controls.placed_window("Pixel panel");
  if (closed) state.picked.reset();
}

void picked_mark(const PixelReport* report, const UiState& state, const PictureArea& area) {
  if (!state.picked || state.view.scale() <= 0.0f) return;
  const auto window = [&](glm::vec2 pixel) { return place_of(pixel, state.view, area); };
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (report && state.show_boundaries) {
    for (const PictureBoundary& b : report->boundaries)
      draw.AddLine(window(b.from), window(b.to), kind_colour(b.kind));
  }
  // A frame around the pixel, with a minimum size.
  const WindowRect at = shown_pixel(*state.picked, state.view, area);
  const ImVec2 lo{at.lo.x, at.lo.y}, hi{at.lo.x + at.size.x, at.lo.y + at.size.y};
  const float grow = std::max(1.0f, 0.5f * (9.0f - (hi.x - lo.x)));
  draw.AddRect({lo.x - grow - 1.0f, lo.y - grow - 1.0f}, {hi.x + grow + 1.0f, hi.y + grow + 1.0f},
               IM_COL32(0, 0, 0, 255));
  draw.AddRect({lo.x - grow, lo.y - grow}, {hi.x + grow, hi.y + grow}, theme::packed(0xffffff));
}

}  // namespace asos::ui
