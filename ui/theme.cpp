#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace asos::ui::theme {

namespace {

// Fonts that Debian packages install, in order of preference. Without any of them Dear ImGui's own
// font is used.
constexpr std::array font_files{
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
};

// Latin, Greek and Cyrillic letters, for names in files, and some typographic characters.
constexpr std::array<ImWchar, 13> glyph_ranges{0x0020, 0x024f, 0x0370, 0x052f, 0x2010,
                                               0x2044, 0x2190, 0x2193, 0x2212, 0x2212,
                                               0x2264, 0x2265, 0};

using Palette = std::array<std::uint32_t, static_cast<std::size_t>(Colour::count)>;
constexpr Palette dark_palette{0x141414, 0x1d1e20, 0x232528, 0x2a2c30, 0x34373c, 0x34373c,
                               0xd8dadd, 0x959aa2, 0x355d8b, 0x6f9fd8, 0xe0705c, 0xd9a94e};
constexpr Palette light_palette{0xc8c8c8, 0xf4f4f5, 0xfcfcfc, 0xe4e6ea, 0xd6dae0, 0xc4c8ce,
                                0x1c1f23, 0x565c66, 0xa9c8ee, 0x2763a8, 0xa82a16, 0x7a4f00};

// The look of the only Dear ImGui context.
Look applied = Look::dark;

ImVec4 colour(Colour of, float alpha = 1.0f) {
  return ImGui::ColorConvertU32ToFloat4(packed(of, alpha));
}

// Gives all digits the width of the widest one, centred, so that changing numbers do not move.
void make_digits_tabular(ImFont& font) {
  const auto is_digit = [](const ImFontGlyph& glyph) {
    return glyph.Codepoint >= '0' && glyph.Codepoint <= '9';
  };
  float widest = 0.0f;
  for (const ImFontGlyph& glyph : font.Glyphs)
    if (is_digit(glyph)) widest = std::max(widest, glyph.AdvanceX);
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (!is_digit(glyph)) continue;
    const float shift = std::floor(0.5f * (widest - glyph.AdvanceX));
    glyph.X0 += shift;
    glyph.X1 += shift;
    glyph.AdvanceX = widest;
  }
  font.BuildLookupTable();
}

void add_font(float pixels) {
  ImGuiIO& io = ImGui::GetIO();
  for (const char* file : font_files) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    if (io.Fonts->AddFontFromFileTTF(file, pixels, &config, glyph_ranges.data())) return;
  }
  ImFontConfig config;
  config.SizePixels = pixels;
  io.Fonts->AddFontDefault(&config);
}

void load_fonts(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  add_font(text_pixels * scale);
  add_font(title_pixels * scale);
  fonts.Build();
  for (ImFont* font : fonts.Fonts) make_digits_tabular(*font);
}

void set_colours(ImGuiStyle& style) {
  const std::pair<ImGuiCol, ImVec4> colours[] = {
      {ImGuiCol_Text, colour(text)},
      {ImGuiCol_TextDisabled, colour(dim_text)},
      {ImGuiCol_WindowBg, colour(panel)},
      {ImGuiCol_ChildBg, colour(panel, 0.0f)},
      {ImGuiCol_PopupBg, colour(popup)},
      {ImGuiCol_Border, colour(line)},
      {ImGuiCol_FrameBg, colour(field)},
      {ImGuiCol_FrameBgHovered, colour(field_hovered)},
      {ImGuiCol_FrameBgActive, colour(field_hovered)},
      {ImGuiCol_TitleBg, colour(popup)},
      {ImGuiCol_TitleBgActive, colour(popup)},
      {ImGuiCol_ScrollbarBg, colour(panel)},
      {ImGuiCol_ScrollbarGrab, colour(line)},
      {ImGuiCol_ScrollbarGrabHovered, colour(dim_text, 0.6f)},
      {ImGuiCol_ScrollbarGrabActive, colour(dim_text, 0.6f)},
      {ImGuiCol_CheckMark, colour(accent_bright)},
      {ImGuiCol_SliderGrab, colour(accent)},
      {ImGuiCol_SliderGrabActive, colour(accent_bright)},
      {ImGuiCol_Button, colour(field)},
      {ImGuiCol_ButtonHovered, colour(field_hovered)},
      {ImGuiCol_ButtonActive, colour(accent)},
      {ImGuiCol_Header, colour(panel)},
      {ImGuiCol_HeaderHovered, colour(field)},
      {ImGuiCol_HeaderActive, colour(field)},
      {ImGuiCol_Separator, colour(line)},
      {ImGuiCol_TextSelectedBg, colour(accent, 0.6f)},
      {ImGuiCol_PlotHistogram, colour(accent)},
      {ImGuiCol_TableHeaderBg, colour(field)},
      {ImGuiCol_TableBorderLight, colour(line)},
      {ImGuiCol_TableRowBgAlt, colour(field, 0.5f)},
      {ImGuiCol_NavHighlight, colour(accent)},
      {ImGuiCol_ModalWindowDimBg, ImVec4(0.0f, 0.0f, 0.0f, 0.45f)},
  };
  for (const auto& [index, value] : colours) style.Colors[index] = value;
}

}  // namespace

std::uint32_t packed(std::uint32_t rgb, float alpha) {
  return IM_COL32((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u,
                  static_cast<unsigned>(alpha * 255.0f + 0.5f));
}

std::uint32_t packed(Colour colour, float alpha) {
  return packed(rgb(colour), alpha);
}

std::uint32_t packed(glm::u8vec3 rgb) {
  return IM_COL32(rgb.x, rgb.y, rgb.z, 255);
}

std::uint32_t rgb(Look look, Colour colour) {
  return (look == Look::light ? light_palette : dark_palette)[static_cast<std::size_t>(colour)];
}

Look look() {
  return applied;
}

std::uint32_t rgb(Colour colour) {
  return rgb(applied, colour);
}

void apply(const Appearance& appearance) {
  applied = appearance.look;
  ImGuiStyle style;
  if (appearance.look == Look::light)
    ImGui::StyleColorsLight(&style);
  else
    ImGui::StyleColorsDark(&style);
  style.WindowPadding = {12, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {8, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 8;
  style.WindowRounding = 0;
  style.PopupRounding = 4;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  set_colours(style);
  style.ScaleAllSizes(appearance.text_scale);
  style.FramePadding.y = 0.5f * (row_pixels - text_pixels) * appearance.text_scale;
  ImGui::GetStyle() = style;

  load_fonts(appearance.text_scale * appearance.raster_scale);
  ImGui::GetIO().FontGlobalScale = 1.0f / appearance.raster_scale;
}

void push_title() {
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
}

void pop_title() {
  ImGui::PopFont();
}

}  // namespace asos::ui::theme
