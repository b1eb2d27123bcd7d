#include "ui/theme.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

namespace asos::theme {

namespace {

// Fonts that Debian installs, the best first. Without one of them Dear ImGui's own is used.
constexpr std::array font_files{
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
};

// Latin, Greek and Cyrillic letters, for the names in files, and some typography.
constexpr std::array<ImWchar, 13> glyph_ranges{0x0020, 0x024f, 0x0370, 0x052f, 0x2010,
                                               0x2044, 0x2190, 0x2193, 0x2212, 0x2212,
                                               0x2264, 0x2265, 0};

ImVec4 colour(std::uint32_t rgb, float alpha = 1.0f) {
  return ImGui::ColorConvertU32ToFloat4(packed(rgb, alpha));
}

void load_font(float pixels) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
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

void set_colours(ImGuiStyle& style) {
  const std::pair<ImGuiCol, ImVec4> colours[] = {
      {ImGuiCol_Text, colour(text)},
      {ImGuiCol_TextDisabled, colour(dim_text)},
      {ImGuiCol_WindowBg, colour(panel)},
      {ImGuiCol_ChildBg, colour(panel, 0.0f)},
      {ImGuiCol_PopupBg, colour(0x232528)},
      {ImGuiCol_Border, colour(line)},
      {ImGuiCol_FrameBg, colour(field)},
      {ImGuiCol_FrameBgHovered, colour(field_hovered)},
      {ImGuiCol_FrameBgActive, colour(field_hovered)},
      {ImGuiCol_TitleBg, colour(0x232528)},
      {ImGuiCol_TitleBgActive, colour(0x232528)},
      {ImGuiCol_ScrollbarBg, colour(panel)},
      {ImGuiCol_ScrollbarGrab, colour(line)},
      {ImGuiCol_ScrollbarGrabHovered, colour(0x44484f)},
      {ImGuiCol_ScrollbarGrabActive, colour(0x44484f)},
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
      {ImGuiCol_NavHighlight, colour(accent)},
      {ImGuiCol_ModalWindowDimBg, colour(0x000000, 0.45f)},
  };
  for (const auto& [index, value] : colours) style.Colors[index] = value;
}

}  // namespace

std::uint32_t packed(std::uint32_t rgb, float alpha) {
  return IM_COL32((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u,
                  static_cast<unsigned>(alpha * 255.0f + 0.5f));
}

void apply(float text_scale, float raster_scale) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 8;
  style.WindowRounding = 0;
  style.PopupRounding = 4;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.ScrollbarRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  set_colours(style);
  style.ScaleAllSizes(text_scale);
  ImGui::GetStyle() = style;

  load_font(text_pixels * text_scale * raster_scale);
  ImGui::GetIO().FontGlobalScale = 1.0f / raster_scale;
}

}  // namespace asos::theme
