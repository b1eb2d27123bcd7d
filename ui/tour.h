#pragma once

#include "renderer/settings/settings.h"
#include "ui/display_settings.h"
#include "ui/frames.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace asos::ui {

class Previewer;
struct UiState;

/// A first look at what the program does: a few cards, each of which acts on the picture that is
/// there. Closing it restores all settings.
struct Tour {
  enum class Card { pyray, split, eps, map, better };
  static constexpr int cards = 5;
  /// How long each level of a pixel's splitting is shown.
  static constexpr double seconds_per_level = 0.9;

  std::optional<Card> card;  ///< none: it is not shown
  bool seen = false;         ///< it was shown once, and comes again only where it is asked for
  double since_seconds = 0.0;
  std::optional<glm::ivec2> pixel;  ///< that the cards speak of
  /// What `pixel` was chosen for.
  struct Chosen {
    std::uint64_t restarts = 0;  ///< of the picture
    Card card = Card::pyray;
    int quarters = 0;    ///< of the picture that were rendered; 5: it was finished
    bool found = false;  ///< `found` was known
    bool operator==(const Chosen&) const = default;
  };
  std::optional<Chosen> chosen;
  std::optional<glm::ivec2> found;  ///< for that, in the finished picture; see SplitPixelSearch
  bool none_split = false;          ///< nor any other: see SplitPixelSearch
  glm::vec2 card_size{0.0f};        ///< as drawn last, in window coordinates; 0: not yet

  struct Before {
    RenderSettings settings;
    DisplaySettings display;
    std::optional<glm::ivec2> picked;
    Comparison comparison = Comparison::none;
    int chosen = 0;  ///< snapshot
  };
  Before before;
  std::string own_source;  ///< that is opened again at the end; empty: the tour opened no other
  std::optional<std::size_t> frames_when_asked;  ///< for a rival, which comes as one more
  std::string rival;                             ///< the name of its frame; empty: none
};

void start_tour(UiState& state, const Previewer& previewer, double now_seconds);
/// To another card; -1 and `Tour::cards` end it.
void show_card(UiState& state, Previewer& previewer, int card, double now_seconds);
/// The scene that the cards are made for.
inline constexpr const char* tour_scene = "builtin:fence";
/// Shows the cards on `tour_scene`, or on the person's own scene again.
void switch_scene(UiState& state, const Previewer& previewer);
/// Restores what was set when the tour began, but for the sky, the background and the ground; and
/// the scene, where the tour opened another one.
void end_tour(UiState& state, Previewer& previewer);

/// The display settings without those of the shown card, for undo steps.
[[nodiscard]] DisplaySettings display_without_card(const UiState& state);
/// The display settings with those of the shown card.
[[nodiscard]] DisplaySettings display_with_card(const UiState& state, DisplaySettings display);

}  // namespace asos::ui
