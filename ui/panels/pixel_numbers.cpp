#include "ui/panels/overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

constexpr float least_scale = 24.0f;        // framebuffer pixels for three lines of digits
constexpr float line_share = 0.28f;         // of the pixel's height
constexpr int most_numbered_pixels = 1500;  // keeps their vertices within 16-bit indices

std::string lines_of(glm::u8vec3 c) {
  return fmt::format("{}\n{}\n{}", c.x, c.y, c.z);
}

// Black on bright pixels, white on dark ones: by Rec. 709 luma.
std::uint32_t readable_on(glm::u8vec3 c) {
  const double luma = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
  return luma > 110.0 ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255);
}

}  // namespace

void pixel_numbers(Controls& controls, const Film& film, const DisplayTransform& display,
                   const PictureView& view, const PictureArea& area) {
  if (view.scale() < least_scale || film.radiance.empty()) return;
  const float side = view.scale() / area.scale;
  const glm::vec2 size = area.rect.size * area.scale;
  const glm::ivec2 first(glm::max(glm::floor(-view.offset() / view.scale()), glm::vec2(0.0f)));
  const glm::ivec2 end = glm::min(glm::ivec2(glm::ceil((size - view.offset()) / view.scale())),
                                  {film.width, film.height});
  const glm::ivec2 count = glm::max(end - first, 0);
  if (count.x == 0 || count.y == 0 || count.x * count.y > most_numbered_pixels) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = ImGui::GetFont();
  const float line = std::min(line_share * side, ImGui::GetFontSize());
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      const glm::u8vec3 c = display_bytes(film, film.index(x, y), display);
      const ImVec2 at = place_of({x, y}, view, area);
      draw.AddText(font, line, {at.x + 0.1f * side, at.y + 0.5f * (side - 3.0f * line)},
                   readable_on(c), lines_of(c).c_str());
    }
  }
  controls.placed_words("Pixel numbers",
                        lines_of(display_bytes(film, film.index(first.x, first.y), display)),
                        nullptr);
}

}  // namespace asos::ui
