#include "ui/tour.h"

#include "ui/previewer.h"
#include "ui/ui_state.h"

#include <utility>

namespace asos::ui {

namespace {

// Sets up the picture for the current card, whatever the previous card did.
void act(UiState& state, double now_seconds) {
  Tour& tour = state.tour;
  tour.since_seconds = now_seconds;
  state.display.show_split_map = tour.before.display.show_split_map;
  state.display.split_colours = tour.before.display.split_colours;
  state.picked = tour.before.picked;
  state.picked_pyray = -1;
  state.shown_level.reset();
  switch (*tour.card) {
    case Tour::Card::pyray:
    case Tour::Card::better:
      break;
    case Tour::Card::split:
      state.picked = tour.pixel;
      state.shown_level = 0;
      break;
    case Tour::Card::eps:
    case Tour::Card::map:
      state.display.show_split_map = true;
      state.display.split_colours = SplitMapColours::level;
      break;
  }
}

void restore(const RenderSettings& before, RenderSettings& settings) {
  RenderSettings back = before;
  back.width = settings.width;
  back.height = settings.height;
  back.threads = settings.threads;
  back.sky = settings.sky;
  back.background = settings.background;
  back.ground = settings.ground;
  settings = std::move(back);
}

}  // namespace

void start_tour(UiState& state, const Previewer& previewer, double now_seconds) {
  Tour& tour = state.tour;
  tour.seen = true;
  tour.pixel.reset();
  tour.chosen.reset();
  // A replayed tour still restores the settings from before its first card.
  if (!tour.card)
    tour.before = {
        previewer.edits().settings(), state.display,      state.picked, state.frames.with,
        state.frames.comparison,      state.frames.chosen};
  tour.card = Tour::Card::pyray;
  act(state, now_seconds);
}

void show_card(UiState& state, Previewer& previewer, int card, double now_seconds) {
  if (card < 0 || card >= Tour::cards) {
    end_tour(state, previewer);
    return;
  }
  state.tour.card = static_cast<Tour::Card>(card);
  act(state, now_seconds);
}

void switch_scene(UiState& state, const Previewer& previewer) {
  if (!previewer.scene()) return;
  Tour& tour = state.tour;
  const std::string shown = previewer.scene()->geometry->source;
  if (shown != tour_scene) {
    tour.own_source = shown;
    state.opening = {tour_scene};
  } else if (!tour.own_source.empty()) {
    state.opening = {std::exchange(tour.own_source, {})};
  }
}

void end_tour(UiState& state, Previewer& previewer) {
  Tour& tour = state.tour;
  if (!tour.card) return;
  if (previewer.scene() && previewer.scene()->geometry->source == tour_scene &&
      !tour.own_source.empty())
    state.opening = {tour.own_source};
  tour.own_source.clear();
  tour.card = Tour::Card::pyray;  // it sets up nothing
  act(state, 0.0);
  tour.card.reset();
  state.display = tour.before.display;
  restore(tour.before.settings, previewer.edits().settings());
  // Removes the tour's snapshot, so that the user is not asked about it when quitting.
  Frames& frames = state.frames;
  for (std::size_t i = frames.stored.size(); i-- > 0;)
    if (frames.stored[i].name == tour.rival) frames.remove(static_cast<int>(i));
  tour.rival.clear();
  tour.frames_when_asked.reset();
  frames.with = tour.before.with;
  frames.comparison = tour.before.comparison;
  if (tour.before.chosen < static_cast<int>(frames.stored.size()))
    frames.chosen = tour.before.chosen;
}

DisplaySettings display_without_card(const UiState& state) {
  DisplaySettings display = state.display;
  if (!state.tour.card) return display;
  display.show_split_map = state.tour.before.display.show_split_map;
  display.split_colours = state.tour.before.display.split_colours;
  return display;
}

DisplaySettings display_with_card(const UiState& state, DisplaySettings display) {
  if (!state.tour.card) return display;
  display.show_split_map = state.display.show_split_map;
  display.split_colours = state.display.split_colours;
  return display;
}

}  // namespace asos::ui
