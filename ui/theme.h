#pragma once

#include <cstdint>

namespace asos::ui::theme {

/// Sizes are in units of the text's height, so that everything follows the screen's scale; at scale
/// 1 they, and all spacing, are multiples of 4 units.
inline constexpr float text_pixels = 15.0f;   ///< at scale 1
inline constexpr float title_pixels = 20.0f;  ///< the one size beside it, a third larger
inline constexpr float row_pixels = 24.0f;    ///< of a widget
inline constexpr float line_pixels = 20.0f;   ///< of a line of text, with the space below it
inline constexpr float panel_width_em = 328.0f / text_pixels;
inline constexpr float status_height_em = 28.0f / text_pixels;
inline constexpr float bar_height_em = 68.0f / text_pixels;  ///< two rows under the picture
inline constexpr float least_bar_em = 26.0f;                 ///< width
inline constexpr float compact_bar_height_em =
    40.0f / text_pixels;                              ///< one row, where room is scarce
inline constexpr float least_compact_bar_em = 16.0f;  ///< width

enum class Look { dark, light };

/// What a colour is for; each look has its own.
enum class Colour : std::uint8_t {
  ground,  ///< around the picture: neutral, so that it does not tint the eye
  panel,
  popup,
  field,
  field_hovered,
  line,
  text,
  dim_text,
  accent,  ///< one is enough; text stands on it
  accent_bright,
  alarm,
  warning,
  count
};
inline constexpr Colour ground = Colour::ground, panel = Colour::panel, popup = Colour::popup,
                        field = Colour::field, field_hovered = Colour::field_hovered,
                        line = Colour::line, text = Colour::text, dim_text = Colour::dim_text,
                        accent = Colour::accent, accent_bright = Colour::accent_bright,
                        alarm = Colour::alarm, warning = Colour::warning;

/// Plots are dark in both looks, as the split map is, whose palette they share; drawings are not.
/// sRGB, 0xRRGGBB.
inline constexpr std::uint32_t plot_ground = 0x141414;
inline constexpr std::uint32_t plot_line = 0x34373c;
inline constexpr std::uint32_t plot_text = 0xd8dadd;

/// sRGB, 0xRRGGBB.
[[nodiscard]] std::uint32_t rgb(Look look, Colour colour);
/// The one that was applied last.
[[nodiscard]] Look look();
/// Of that look.
[[nodiscard]] std::uint32_t rgb(Colour colour);

/// For Dear ImGui's packed colours.
[[nodiscard]] std::uint32_t packed(std::uint32_t rgb, float alpha = 1.0f);
[[nodiscard]] std::uint32_t packed(Colour colour, float alpha = 1.0f);

/// How the window is drawn. `text_scale` multiplies all sizes in window coordinates; the font is
/// rastered `raster_scale` times finer (screens whose framebuffer has more pixels than the window
/// has units).
struct Appearance {
  Look look = Look::dark;
  float text_scale = 1.0f;
  float raster_scale = 1.0f;
  bool operator==(const Appearance&) const = default;
};

/// Gives the current Dear ImGui context, of which there is one at a time, its colours, spacing and
/// fonts, whose digits are all of one width. Call between frames; the renderer's font texture has
/// to be made anew afterwards.
void apply(const Appearance& appearance);

/// Between these, text is as large as titles.
void push_title();
void pop_title();

}  // namespace asos::ui::theme
