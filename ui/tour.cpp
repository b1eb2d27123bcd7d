#include "ui/tour.h"

#include "ui/ui_state.h"

namespace asos {

namespace {

// The picture as a card needs it, whatever the card before it has left.
void act(UiState& state, double now_seconds) {
  Tour& tour = state.tour;
  tour.since_seconds = now_seconds;
  state.display.show_split_map = tour.before.show_split_map;
  state.display.split_colours = tour.before.colours;
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

}  // namespace

void start_tour(UiState& state, double now_seconds) {
  end_tour(state);
  Tour& tour = state.tour;
  tour.seen = true;
  tour.pixel.reset();
  tour.before = {state.display.show_split_map, state.display.split_colours, state.picked,
                 state.frames.comparison};
  show_card(state, 0, now_seconds);
}

void show_card(UiState& state, int card, double now_seconds) {
  if (card < 0 || card >= Tour::cards) {
    end_tour(state);
    return;
  }
  state.tour.card = static_cast<Tour::Card>(card);
  act(state, now_seconds);
}

void end_tour(UiState& state) {
  Tour& tour = state.tour;
  if (!tour.card) return;
  tour.card = Tour::Card::pyray;  // which shows nothing
  act(state, 0.0);
  tour.card.reset();
  // Nobody is asked about a frame that he did not store.
  Frames& frames = state.frames;
  for (std::size_t i = frames.stored.size(); i-- > 0;)
    if (frames.stored[i].name == tour.rival) frames.remove(static_cast<int>(i));
  tour.rival.clear();
  tour.frames_when_asked.reset();
  frames.comparison = tour.before.comparison;
}

}  // namespace asos
