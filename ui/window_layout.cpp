#include "ui/window_layout.h"

#include "ui/theme.h"

#include <algorithm>
#include <cmath>

namespace asos::ui {

WindowLayout WindowLayout::of(glm::vec2 window, float em, bool show_panel, bool show_bar,
                              bool show_timeline) {
  // Minimum width of a picture next to the panel, in widths of the panel.
  constexpr float least_picture = 0.5f;
  constexpr float least_height = 400.0f;  // of a window with a panel, at any size of text
  show_panel = show_panel && window.y >= least_height;
  const float panel_width = std::round(theme::panel_width_em * em);
  const bool beside = window.x >= std::round((1.0f + least_picture) * panel_width);
  const float taken_across = show_panel && beside ? panel_width : 0.0f;
  const float taken_down = show_panel && !beside ? std::round(0.5f * window.y) : 0.0f;
  const float status = std::min(std::round(theme::status_height_em * em),
                                std::round(0.5f * (window.y - taken_down)));
  const float above_status = window.y - taken_down - status;
  const float across = std::floor(window.x - taken_across);
  // Low or narrow windows have one row or none, to leave room for the picture.
  const auto fits = [&](float width_em, float height_em, float times) {
    return across >= width_em * em && above_status >= times * height_em * em;
  };
  float bar_em = 0.0f;
  if (fits(theme::least_compact_bar_em, theme::compact_bar_height_em, 2.5f))
    bar_em = theme::compact_bar_height_em;
  if (fits(theme::least_bar_em, theme::bar_height_em, 4.0f)) bar_em = theme::bar_height_em;
  const float bar = show_bar ? std::round(bar_em * em) : 0.0f;
  const bool has_timeline = show_timeline && fits(theme::least_compact_bar_em,
                                                  theme::compact_bar_height_em + bar_em, 2.5f);
  const float timeline = has_timeline ? std::round(theme::compact_bar_height_em * em) : 0.0f;
  const glm::vec2 picture(across, std::floor(above_status - bar - timeline));

  WindowLayout layout;
  layout.picture = {{0.0f, 0.0f}, picture};
  layout.timeline = {{0.0f, picture.y}, {picture.x, timeline}};
  layout.bar = {{0.0f, picture.y + timeline}, {picture.x, bar}};
  const float above = picture.y + timeline + bar;
  layout.status = {{0.0f, above}, {picture.x, window.y - taken_down - above}};
  layout.panel = {{0.0f, 0.0f}, {0.0f, 0.0f}};
  if (show_panel && beside) layout.panel = {{picture.x, 0.0f}, {window.x - picture.x, window.y}};
  if (show_panel && !beside) layout.panel = {{0.0f, window.y - taken_down}, {window.x, taken_down}};
  return layout;
}

bool has_room_for_tour(const WindowLayout& layout, float em) {
  constexpr float across_em = 44.0f, down_em = 44.0f, above_panel_em = 24.0f, least_em = 14.0f;
  const glm::vec2 picture = layout.picture.size / em;
  const bool below = layout.panel.size.y > 0.0f && layout.panel.lo.x <= layout.picture.lo.x;
  if (below) return picture.y >= above_panel_em;
  return picture.y >= least_em && (picture.x >= across_em || picture.y >= down_em);
}

float fitting_text_scale(float asked, float window_width) {
  // Steps of 1/8, so that resizing does not rebuild the fonts in every frame.
  constexpr float steps = 8.0f;
  const float fits = window_width / (theme::panel_width_em * theme::text_pixels);
  return std::min(asked, std::max(1.0f, std::floor(steps * fits) / steps));
}

}  // namespace asos::ui
