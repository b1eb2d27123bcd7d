#pragma once

#include "ui/display_settings.h"
#include "ui/frames.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace asos {

struct UiState;

/// A first look at what the program does: a few cards, each of which acts on the picture that is
/// there. What the cards show is put back when they are left.
struct Tour {
  enum class Card { pyray, split, eps, map, better };
  static constexpr int cards = 5;
  /// How long each level of a pixel's splitting is shown.
  static constexpr double seconds_per_level = 0.9;

  std::optional<Card> card;  ///< none: it is not shown
  bool seen = false;         ///< it was shown once, and comes again only where it is asked for
  double since_seconds = 0.0;
  std::optional<glm::ivec2> pixel;  ///< that the cards speak of
  std::optional<glm::ivec2> found;  ///< for that, in the finished picture; see SplitPixelSearch
  bool none_split = false;          ///< nor any other: see SplitPixelSearch

  struct Before {
    bool show_split_map = false;
    SplitMapColours colours = SplitMapColours::level;
    std::optional<glm::ivec2> picked;
    Comparison comparison = Comparison::none;
  };
  Before before;
  std::optional<std::size_t> frames_when_asked;  ///< for a rival, which comes as one more
  std::string rival;                             ///< the name of its frame; empty: none
};

void start_tour(UiState& state, double now_seconds);
/// To another card; -1 and `Tour::cards` end it.
void show_card(UiState& state, int card, double now_seconds);
void end_tour(UiState& state);

}  // namespace asos
