#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace asos::ui::theme {

/// Sizes are in units of the text's height, so that they scale with the screen; at scale 1 all
/// sizes and spacings are multiples of 4 units.
inline constexpr float text_pixels = 15.0f;   ///< at scale 1
inline constexpr float title_pixels = 20.0f;  ///< the only other text size, a third larger
inline constexpr float row_pixels = 24.0f;    ///< of a widget
inline constexpr float line_pixels = 20.0f;   ///< height of a line of text with the space below it
inline constexpr float panel_width_em = 328.0f / text_pixels;
inline constexpr float status_height_em = 28.0f / text_pixels;
inline constexpr float bar_height_em = 68.0f / text_pixels;          ///< two rows below the picture
inline constexpr float least_bar_em = 26.0f;                         ///< width
inline constexpr float compact_bar_height_em = 40.0f / text_pixels;  ///< one row
inline constexpr float least_compact_bar_em = 16.0f;                 ///< width

enum class Look { dark, light };

/// The purpose of each colour; each look defines its own.
enum class Colour : std::uint8_t {
  ground,  ///< around the picture: grey, so that it does not bias colour perception
  panel,
  popup,
  field,
  field_hovered,
  line,
  text,
  dim_text,
  accent,  ///< the only accent colour; text is drawn on it
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

/// Plots are dark in both looks, like the split map, whose palette they share; other drawings
/// follow the look. sRGB, 0xRRGGBB.
inline constexpr std::uint32_t plot_ground = 0x141414;
inline constexpr std::uint32_t plot_line = 0x34373c;
inline constexpr std::uint32_t plot_text = 0xd8dadd;

/// sRGB, 0xRRGGBB.
[[nodiscard]] std::uint32_t rgb(Look look, Colour colour);
/// The look that was applied last.
[[nodiscard]] Look look();
/// Returns a colour of that look.
[[nodiscard]] std::uint32_t rgb(Colour colour);

/// Converts to Dear ImGui's packed colours.
[[nodiscard]] std::uint32_t packed(std::uint32_t rgb, float alpha = 1.0f);
[[nodiscard]] std::uint32_t packed(Colour colour, float alpha = 1.0f);
[[nodiscard]] std::uint32_t packed(glm::u8vec3 rgb);

/// How the window is drawn. `text_scale` multiplies all sizes in window coordinates. The font is
/// rasterised `raster_scale` times finer, for screens with more pixels than window units.
struct Appearance {
  Look look = Look::dark;
  float text_scale = 1.0f;
  float raster_scale = 1.0f;
  bool operator==(const Appearance&) const = default;
};

/// Sets colours, spacing and fonts (with digits of equal width) of the current Dear ImGui context.
/// There may be only one context. Call between frames; the renderer's font texture has to be
/// rebuilt afterwards.
void apply(const Appearance& appearance);

/// Text between these calls has the size of titles.
void push_title();
void pop_title();

}  // namespace asos::ui::theme
