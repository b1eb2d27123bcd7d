#pragma once

#include "renderer/settings/settings.h"
#include "ui/display_settings.h"
#include "ui/frames.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace asos::ui {

class Previewer;
struct UiState;

/// The introductory tour: a few cards that each demonstrate something on the current picture.
/// Closing it restores all settings.
struct Tour {
  enum class Card { pyray, split, eps, map, better };
  static constexpr int cards = 5;
  /// Display time of each level of a pixel's splitting.
  static constexpr double seconds_per_level = 0.9;

  std::optional<Card> card;  ///< none: it is not shown
  bool seen = false;         ///< it was shown once; from then on only on request
  double since_seconds = 0.0;
  std::optional<glm::ivec2> pixel;  ///< the pixel that the cards explain
  /// The situation in which `pixel` was chosen.
  struct Chosen {
    std::uint64_t restarts = 0;  ///< of the picture
    Card card = Card::pyray;
    int quarters = 0;    ///< quarters of the picture that were rendered; 5: finished
    int samples = 0;     ///< samples of every pixel so far
    bool found = false;  ///< `found` was known
    bool clear = false;  ///< `pixel` was on a clear edge
    bool operator==(const Chosen&) const = default;
  };
  std::optional<Chosen> chosen;
  std::optional<glm::ivec2> found;  ///< in the finished picture: see SplitPixelSearch
  bool none_split = false;          ///< no pixel was split: see SplitPixelSearch
  /// Heights of a card by its widths (see card_place), for one card and size of text and picture.
  struct Drawn {
    Card card = Card::pyray;
    float em = 0.0f;
    float room = 0.0f;  ///< width of the picture
    std::array<float, 4> heights{};
    bool settled = false;  ///< the last frame drew the card with its own height
  };
  Drawn drawn;

  struct Before {
    RenderSettings settings;
    DisplaySettings display;
    std::optional<glm::ivec2> picked;
    CompareWith with = CompareWith::snapshot;
    Comparison comparison = Comparison::none;
    int chosen = 0;  ///< snapshot
  };
  Before before;
  std::string own_source;                        ///< scene to open again at the end; empty: none
  std::optional<std::size_t> frames_when_asked;  ///< number of snapshots before the other method's
  std::string rival;  ///< name of the other method's snapshot; empty: none
};

void start_tour(UiState& state, const Previewer& previewer, double now_seconds);
/// Goes to this card; -1 and `Tour::cards` end the tour.
void show_card(UiState& state, Previewer& previewer, int card, double now_seconds);
/// The scene that the cards are made for.
inline constexpr const char* tour_scene = "builtin:fence";
/// Opens `tour_scene`, or the user's own scene again.
void switch_scene(UiState& state, const Previewer& previewer);
/// Restores the settings from before the tour, except threads, sky, background and ground; also the
/// scene, if the tour opened another one.
void end_tour(UiState& state, Previewer& previewer);

/// The display settings without the changes of the current card, for undo steps.
[[nodiscard]] DisplaySettings display_without_card(const UiState& state);
/// The display settings with the changes of the current card.
[[nodiscard]] DisplaySettings display_with_card(const UiState& state, DisplaySettings display);

}  // namespace asos::ui
