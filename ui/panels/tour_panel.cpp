#include "ui/panels/tour_panel.h"

#include "renderer/comparison/method.h"
#include "ui/panels/card_place.h"
#include "ui/panels/overlay_window.h"
#include "ui/panels/pixel_place.h"
#include "ui/panels/sketch.h"
#include "ui/split_pixel.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

constexpr const char* none_is_split =
    "Edges cut this pixel cleanly, so exact areas are used. Otherwise a pixel is split into four, "
    "again and again.";

struct CardWords {
  const char* title;
  const char* text;
};
constexpr std::array<CardWords, Tour::cards> card_words{{
    {"A pixel is a pyramid",
     "A pixel sees a pyramid of space. Everything inside it contributes to the pixel's colour. The "
     "marked pixel below contains an edge."},
    {"Watch this pixel split",
     "If one sample is not enough, the pyramid is split into four, again and again. Where a few "
     "edges cut it cleanly, their exact areas are used."},
    {"Drag EPS",
     "EPS is the error you accept per pixel. Drag left for more splitting, right for less."},
    {"See the map",
     "Dark: one sample was enough. Purple: exact, cut along edges. Blue to yellow: split deeper. "
     "Press M to toggle the map; click a pixel to see why."},
    {"Which method is better?",
     "Give another method the same CPU time and compare with a draggable divider. \"Error vs. "
     "time\" in the panel measures both."},
}};

// Draws the pixels around one of the picture's pixels, enlarged.
void loupe(Controls& controls, const Film& film, glm::ivec2 pixel,
           const DisplayTransform& display) {
  constexpr int columns = 16, rows = 5;
  const float side = ImGui::GetContentRegionAvail().x / columns;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({side * columns, side * rows});
  controls.placed("Loupe", nullptr);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const glm::ivec2 first = pixel - glm::ivec2(columns, rows) / 2;
  const auto lo = [&](glm::ivec2 cell) {
    return ImVec2{corner.x + side * static_cast<float>(cell.x),
                  corner.y + side * static_cast<float>(cell.y)};
  };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const glm::ivec2 at = first + glm::ivec2(x, y);
      if (at.x < 0 || at.y < 0 || at.x >= film.width || at.y >= film.height) continue;
      draw.AddRectFilled(lo({x, y}), lo({x + 1, y + 1}),
                         theme::packed(display_bytes(film, film.index(at.x, at.y), display)));
    }
  }
  const glm::ivec2 middle = glm::ivec2(columns, rows) / 2;
  draw.AddRect(lo(middle), lo(middle + 1), IM_COL32(0, 0, 0, 255), 0.0f, 0, 5.0f);
  draw.AddRect(lo(middle), lo(middle + 1), IM_COL32(255, 255, 255, 255), 0.0f, 0, 2.0f);
}

void eps_slider(Controls& controls, Previewer& previewer, std::optional<double> split_share) {
  RenderSettings& settings = previewer.edits().settings();
  controls.log_slider(
      "Tolerance (EPS)",
      "Error allowed per pixel, 0 to 1. Double-click to reset. Closing the tour restores it.",
      settings.asos.eps, {0.0, 1.0, RenderSettings{}.asos.eps},
      [](double eps) { return eps > 0.0 ? fmt::format("1/{:.0f}", 1.0 / eps) : std::string("0"); });
  controls.row(
      "Split",
      split_share ? fmt::format("{:.1f} % of pixels", 100.0 * *split_share) : std::string("-"),
      "Percentage of split pixels: estimated from a few blocks, then counted.");
}

void map_choice(Controls& controls, DisplaySettings& display) {
  constexpr std::array options{
      Controls::Option{"Level", "Deepest level of each pixel."},
      Controls::Option{"Cause", "Cause: silhouettes, creases, shadows, reflections."},
      Controls::Option{"Rays", "Rays per pixel."},
  };
  int colours = std::min(static_cast<int>(display.split_colours), 2);
  if (controls.options("Map by", options, colours, {true, 0}))
    display.split_colours = static_cast<SplitMapColours>(colours);
}

void ask_rival(Controls& controls, const Previewer& previewer, UiState& state, EqualTimeJob& job) {
  const bool finished = previewer.render().progress().finished;
  Tour& tour = state.tour;
  if (tour.frames_when_asked && state.frames.stored.size() > *tour.frames_when_asked) {
    tour.rival = state.frames.stored.back().name;
    tour.frames_when_asked.reset();
  }
  if (controls.button("Compare now",
                      "Render the view by the method of \"Compare\" in the same CPU time. The "
                      "result appears right of a divider.")) {
    if (start_equal_time(previewer, state.equal_time, job, state.frames))
      tour.frames_when_asked = state.frames.stored.size();
    else if (!job.busy())
      state.said = finished ? "Nine snapshots at most: delete one first"
                            : "Wait until the picture is finished";
  }
  ImGui::SameLine();
  std::string words =
      finished ? row_of(state.equal_time.method).title : std::string("(when finished)");
  if (state.frames.comparison == Comparison::wipe && !job.busy()) words += " is on the right";
  ImGui::TextDisabled("%s", words.c_str());
  if (job.busy()) equal_time_progress(controls, state.equal_time);
}

// A button to open the tour's scene, or the user's own scene again.
void scene_button(Controls& controls, const Previewer& previewer, UiState& state) {
  if (!previewer.scene()) return;
  const bool own = previewer.scene()->geometry->source != tour_scene;
  if (!own && state.tour.own_source.empty()) return;
  if (controls.button(own ? "Show on the fence scene" : "Show on my scene",
                      own ? "Open a scene with many thin edges. Closing the tour reopens yours."
                          : "Open your scene again."))
    switch_scene(state, previewer);
}

// The drawing or detail of the picture that belongs to the card.
void body(Controls& controls, Previewer& previewer, UiState& state, EqualTimeJob& job,
          float room_down, double now_seconds) {
  const Film& film = previewer.render().film();
  const float width = ImGui::GetContentRegionAvail().x;
  switch (*state.tour.card) {
    case Tour::Card::pyray:
      // Low windows have room only for the drawing or the loupe.
      if (room_down > 28.0f * ImGui::GetFontSize() || !state.tour.pixel) draw_pyray(Sketch(width));
      if (state.tour.pixel) loupe(controls, film, *state.tour.pixel, state.display.transform());
      scene_button(controls, previewer, state);
      break;
    case Tour::Card::split:
      if (!state.tour.pixel) {
        ImGui::TextDisabled("%s", previewer.render().progress().finished
                                      ? "No pixel is split."
                                      : "Waiting for a pixel that is split.");
        break;
      }
      if (controls.button("Replay", "Show the splitting from the whole pixel again.")) {
        state.picked = state.tour.pixel;  // the inspector may have been closed
        state.shown_level = 0;
        state.tour.since_seconds = now_seconds;
      }
      ImGui::SameLine();
      if (state.shown_level) ImGui::TextDisabled("level %d", *state.shown_level);
      break;
    case Tour::Card::eps:
      eps_slider(controls, previewer, state.split_share);
      break;
    case Tour::Card::map:
      map_choice(controls, state.display);
      break;
    case Tour::Card::better:
      ask_rival(controls, previewer, state, job);
      break;
  }
}

// Keeps the next button in the line if the card is wide enough.
void stay_in_line(const char* name) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(name).x + 2.0f * style.FramePadding.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
}

// The buttons of a card. Returns the card to go to; none: stay. The first button keeps its place,
// so that it can be clicked repeatedly.
std::optional<int> buttons(Controls& controls, int card) {
  std::optional<int> next;
  const bool last = card + 1 == Tour::cards;
  const char* end = "Close the tour (Esc).";
  ImGui::Spacing();
  if (last) {
    if (controls.button("Done", end)) next = Tour::cards;
  } else if (controls.button("Next", "Next card.")) {
    next = card + 1;
  }
  if (card > 0) {
    stay_in_line("Previous");
    if (controls.button("Previous", "Previous card.")) next = card - 1;
  }
  if (!last) {
    stay_in_line("Close tour");
    if (controls.button("Close tour", end)) next = Tour::cards;
  }
  const std::string count = fmt::format("{} of {}", card + 1, Tour::cards);
  const float left = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x;
  ImGui::SameLine();
  if (ImGui::GetCursorPosX() > left) ImGui::NewLine();
  ImGui::SetCursorPosX(left);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", count.c_str());
  return next;
}

// The first card's pixel is on a clear edge of the current picture. The second card's is final and
// split, too: from the unfinished picture until SplitPixelSearch has one.
std::optional<glm::ivec2> pixel_for_card(const Previewer& previewer, const UiState& state) {
  const Tour& tour = state.tour;
  const Film& film = previewer.render().film();
  const bool watched = *tour.card == Tour::Card::split;
  if (watched && tour.found) return tour.found;
  const auto edge = clear_edge_pixel(film, state.display.transform(),
                                     watched ? ClearEdge::split : ClearEdge::any);
  return edge ? edge : most_split_pixel(film);
}

// Whether the first card's pixel was on a clear edge when it was chosen, and is no more. Coarse
// passes show edges where blocks meet.
bool lost_its_edge(const Film& film, const UiState& state) {
  const Tour& tour = state.tour;
  return tour.pixel && tour.chosen && tour.chosen->clear &&
         !on_clear_edge(film, *tour.pixel, state.display.transform());
}

void choose_pixel(const Previewer& previewer, UiState& state, double now_seconds) {
  Tour& tour = state.tour;
  const bool watched = *tour.card == Tour::Card::split;
  if (*tour.card > Tour::Card::split) return;
  const PreviewRender& render = previewer.render();
  // The first card's pixel may change with each round of samples and each rendered quarter of the
  // picture, the second's only when the search ends.
  const Progress progress = render.progress();
  const int quarters = progress.finished ? 5 : static_cast<int>(4.0 * progress.fraction);
  Tour::Chosen now{render.restarts(), *tour.card, quarters, render.reached().samples,
                   tour.found.has_value()};
  const Film& film = render.film();
  if (tour.chosen) now.clear = tour.chosen->clear;
  const bool keeps = tour.chosen == now && (watched || !lost_its_edge(film, state));
  const bool still = tour.pixel && watched && tour.chosen && tour.chosen->card == now.card &&
                     tour.chosen->restarts == now.restarts && !tour.found;
  if (keeps || still) return;
  const std::optional<glm::ivec2> pixel = pixel_for_card(previewer, state);
  now.clear = pixel && on_clear_edge(film, *pixel, state.display.transform());
  // A late result does not reopen an inspector that was closed on this card.
  const bool closed = tour.pixel && tour.chosen && tour.chosen->card == now.card && !state.picked;
  tour.chosen = now;
  if (pixel == tour.pixel && (!watched || pixel == state.picked)) return;
  tour.pixel = pixel;
  if (!watched || closed) return;
  state.picked = pixel;
  state.shown_level = 0;
  tour.since_seconds = now_seconds;
}

void next_level(UiState& state, int deepest, double now_seconds) {
  if (!state.shown_level) return;
  if (now_seconds - state.tour.since_seconds < Tour::seconds_per_level) return;
  state.tour.since_seconds = now_seconds;
  if (++*state.shown_level > deepest) state.shown_level.reset();
}

// Forgets the heights of another card, size of text or window.
void renew_heights(Tour& tour, float em, float room) {
  Tour::Drawn& drawn = tour.drawn;
  if (drawn.card != *tour.card || drawn.em != em || drawn.room != room)
    drawn = {*tour.card, em, room, {}, false};
}

// Notes the height of the card that was just laid out in the current window. Other heights are of
// the card's old contents if it has changed.
void note_height(Tour::Drawn& drawn, const CardPlace& place) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float height =
      std::ceil(ImGui::GetCursorPosY() - style.ItemSpacing.y + style.WindowPadding.y);
  drawn.settled = true;
  // The scroll bar of a card that is too high takes some of its width.
  if (place.too_high || height == drawn.heights[place.index]) return;
  if (drawn.heights[place.index] > 0.0f) drawn.heights.fill(0.0f);
  drawn.heights[place.index] = height;
  drawn.settled = false;
}

// The areas that a card must leave free: other panels, and the picked pixel.
std::vector<WindowRect> taken_places(const Controls& controls, const UiState& state,
                                     const PictureArea& area) {
  std::vector<WindowRect> taken;
  for (const char* name : {"Pixel panel", "Map legend"}) {
    const auto at = controls.all().find(name);
    if (at != controls.all().end()) taken.push_back({at->second.lo, at->second.hi - at->second.lo});
  }
  if (state.picked && state.view.scale() > 0.0f) {
    const float clear = ImGui::GetFontSize();
    const WindowRect pixel = shown_pixel(*state.picked, state.view, area);
    taken.push_back({pixel.lo - clear, pixel.size + 2.0f * clear});
  }
  return taken;
}

}  // namespace

void tour_panel(Controls& controls, Previewer& previewer, UiState& state, EqualTimeJob& equal_time,
                const PictureArea& area, double now_seconds) {
  if (std::exchange(state.tour_asked, false)) start_tour(state, previewer, now_seconds);
  if (!state.tour.card) return;
  const float em = ImGui::GetFontSize();
  state.tour.drawn.settled = true;
  if (area.rect.size.x < 13.0f * em || area.rect.size.y < 10.0f * em) return;
  choose_pixel(previewer, state, now_seconds);
  next_level(state, previewer.edits().settings().asos.max_level, now_seconds);

  renew_heights(state.tour, em, area.rect.size.x);
  const CardPlace place = card_place(room_for_card(area.rect, em), state.tour.drawn.heights,
                                     taken_places(controls, state, area), em);
  ImGui::SetNextWindowPos({place.lo.x, place.lo.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  const OverlayWindow window("tour", place.too_high ? 0 : ImGuiWindowFlags_NoScrollbar);
  const int card = static_cast<int>(*state.tour.card);
  const CardWords& words = card_words[static_cast<std::size_t>(card)];
  theme::push_title();
  ImGui::TextUnformatted(words.title);
  theme::pop_title();
  const bool none = state.tour.none_split && *state.tour.card == Tour::Card::split;
  ImGui::TextWrapped("%s", none ? none_is_split : words.text);
  body(controls, previewer, state, equal_time, area.rect.size.y, now_seconds);
  const std::optional<int> next = buttons(controls, card);
  controls.placed_window("Card");
  note_height(state.tour.drawn, place);
  if (next) show_card(state, previewer, *next, now_seconds);
}

std::optional<double> seconds_to_card(const UiState& state, double now_seconds) {
  if (!state.tour.card) return std::nullopt;
  if (!state.tour.drawn.settled) return 0.0;
  if (!state.shown_level) return std::nullopt;
  return std::max(0.0, state.tour.since_seconds + Tour::seconds_per_level - now_seconds);
}

}  // namespace asos::ui
