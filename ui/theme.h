#pragma once

#include <cstdint>

namespace asos::theme {

/// Sizes are in units of the text's height, so that everything follows the screen's scale.
inline constexpr float text_pixels = 15.0f;  ///< at scale 1
inline constexpr float panel_width_em = 21.5f;
inline constexpr float status_height_em = 1.9f;

// Colours as sRGB, 0xRRGGBB. The ground around the picture is a neutral dark grey, so that it does
// not tint the eye; one accent is enough.
inline constexpr std::uint32_t ground = 0x141414;
inline constexpr std::uint32_t panel = 0x1d1e20;
inline constexpr std::uint32_t field = 0x2a2c30;
inline constexpr std::uint32_t field_hovered = 0x34373c;
inline constexpr std::uint32_t line = 0x34373c;
inline constexpr std::uint32_t text = 0xd8dadd;
inline constexpr std::uint32_t dim_text = 0x959aa2;
inline constexpr std::uint32_t accent = 0x3f6b9e;
inline constexpr std::uint32_t accent_bright = 0x6f9fd8;
inline constexpr std::uint32_t alarm = 0xe0705c;
inline constexpr std::uint32_t warning = 0xd9a94e;

/// Gives the current Dear ImGui context its colours, spacing and font. `text_scale` multiplies all
/// sizes in window coordinates; the font is rastered `raster_scale` times finer (screens whose
/// framebuffer has more pixels than the window has units). Call between frames; the renderer's
/// font texture has to be made anew afterwards.
void apply(float text_scale, float raster_scale);

/// For Dear ImGui's packed colours.
[[nodiscard]] std::uint32_t packed(std::uint32_t rgb, float alpha = 1.0f);

}  // namespace asos::theme
