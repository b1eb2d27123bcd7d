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

std::optional<glm::ivec2> most_split_pixel(const Film& film) {
  // Shadows and mirrors have pyrays of their own: what bounds an object splits the pixel itself,
  // and what is not resolved at MAX has split it all the way.
  const auto rank = [&](std::size_t i) {
    const SplitCause cause = film.cause[i];
    const bool bounded = cause == SplitCause::outline || cause == SplitCause::crease ||
                         cause == SplitCause::intersection;
    if (film.split_level[i] == 0) return 0;
    const int sort = cause == SplitCause::depth_limit ? 2 : (bounded ? 1 : 0);
    return film.split_level[i] + 256 * sort;
  };
  std::optional<glm::ivec2> best;
  int level = 0;
  double distance = 0.0;
  const glm::dvec2 middle = 0.5 * glm::dvec2(film.width, film.height);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const int here = rank(film.index(x, y));
      if (here == 0 || here < level) continue;
      const double away = glm::distance(glm::dvec2(x + 0.5, y + 0.5), middle);
      if (here == level && away >= distance) continue;
      best = glm::ivec2(x, y);
      level = here;
      distance = away;
    }
  }
  return best;
}

}  // namespace asos
