#include "ui/legend_strip.h"

#include "renderer/film/split_cause.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace asos::ui {

namespace {

constexpr std::uint8_t strip_ground = 0x18, strip_text = 0xe0;

constexpr std::array rays_steps{CostStep{1, "1 ray"},  CostStep{4, "4"},     CostStep{16, "16"},
                                CostStep{64, "64"},    CostStep{256, "256"}, CostStep{1024, "1024"},
                                CostStep{4096, "4096"}};
constexpr std::array time_steps{CostStep{1e-7, "0.1 \u00b5s"}, CostStep{1e-6, "1 \u00b5s"},
                                CostStep{1e-5, "10 \u00b5s"},  CostStep{1e-4, "0.1 ms"},
                                CostStep{1e-3, "1 ms"},        CostStep{1e-2, "10 ms"}};

std::vector<LegendEntry> cost_entries(SplitMapColours colours) {
  const SplitMapKey key{colours};
  std::vector<LegendEntry> entries;
  for (const CostStep& step : cost_steps(colours)) {
    const double share = cost_scale(colours).share(step.value);
    entries.push_back(
        {key.colour(static_cast<std::uint8_t>(1.0 + std::round(254.0 * share))), step.words});
  }
  return entries;
}

/// Draws text and swatches into an image, with the pixels of the ImGui font.
class Strip {
 public:
  Strip(RgbImage& image, int first_row) : image_(image), first_row_(first_row) {
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&atlas_, &atlas_width_, &atlas_height_);
  }

  void fill(int x, int y, int width, int height, glm::u8vec3 colour) {
    for (int row = y; row < y + height; ++row)
      for (int column = x; column < x + width; ++column) blend(column, row, colour, 1.0f);
  }

  void text(float x, float y, const std::string& words) {
    const ImFont& font = *ImGui::GetFont();
    const char* at = words.data();
    const char* end = at + words.size();
    while (at < end) {
      unsigned int character = 0;
      at += decode(at, end, character);
      const ImFontGlyph* glyph = font.FindGlyph(static_cast<ImWchar>(character));
      if (glyph->Visible) draw(*glyph, x, y);
      x += glyph->AdvanceX;
    }
  }

 private:
  // Decodes UTF-8 of one or two bytes.
  static int decode(const char* at, const char* end, unsigned int& character) {
    const auto first = static_cast<unsigned char>(*at);
    if (first < 0x80 || at + 1 >= end) {
      character = first;
      return 1;
    }
    character = (first & 0x1fu) << 6 | (static_cast<unsigned char>(at[1]) & 0x3fu);
    return 2;
  }

  void draw(const ImFontGlyph& glyph, float x, float y) {
    const float width = glyph.X1 - glyph.X0, height = glyph.Y1 - glyph.Y0;
    const int left = static_cast<int>(std::round(x + glyph.X0));
    const int top = static_cast<int>(std::round(y + glyph.Y0));
    // Averages the atlas's several texels per pixel in x.
    constexpr int taps = 3;
    for (int row = 0; row < static_cast<int>(std::ceil(height)); ++row) {
      for (int column = 0; column < static_cast<int>(std::ceil(width)); ++column) {
        float cover = 0.0f;
        for (int tap = 0; tap < taps; ++tap) {
          const float u =
              (static_cast<float>(column) + (static_cast<float>(tap) + 0.5f) / taps) / width;
          const float v = (static_cast<float>(row) + 0.5f) / height;
          cover += texel(glm::mix(glyph.U0, glyph.U1, u), glm::mix(glyph.V0, glyph.V1, v)) / taps;
        }
        blend(left + column, top + row, glm::u8vec3(strip_text), cover);
      }
    }
  }

  [[nodiscard]] float texel(float u, float v) const {
    const int x =
        std::clamp(static_cast<int>(u * static_cast<float>(atlas_width_)), 0, atlas_width_ - 1);
    const int y =
        std::clamp(static_cast<int>(v * static_cast<float>(atlas_height_)), 0, atlas_height_ - 1);
    return static_cast<float>(atlas_[y * atlas_width_ + x]) / 255.0f;
  }

  void blend(int x, int y, glm::u8vec3 colour, float cover) {
    const int row = first_row_ + y;
    if (x < 0 || x >= image_.width || y < 0 || row >= image_.height) return;
    const auto first = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
                            static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c) {
      std::uint8_t& byte = image_.rgb[first + static_cast<std::size_t>(c)];
      byte = static_cast<std::uint8_t>(
          std::lround(glm::mix(static_cast<float>(byte), static_cast<float>(colour[c]), cover)));
    }
  }

  RgbImage& image_;
  int first_row_;
  unsigned char* atlas_ = nullptr;
  int atlas_width_ = 0, atlas_height_ = 0;
};

float width_of(const std::string& words) {
  const ImFont& font = *ImGui::GetFont();
  return font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, words.c_str()).x;
}

}  // namespace

std::string legend_title(SplitMapColours colours) {
  switch (colours) {
    case SplitMapColours::cause:
      return "Why pixels were split";
    case SplitMapColours::rays:
      return "Rays per pixel";
    case SplitMapColours::time:
      return "CPU time per pixel";
    case SplitMapColours::level:
      break;
  }
  return "Deepest level of each pixel";
}

std::span<const CostStep> cost_steps(SplitMapColours colours) {
  if (colours == SplitMapColours::rays) return rays_steps;
  return time_steps;
}

CauseCounts count_causes(const Film& film) {
  CauseCounts counts;
  for (std::size_t i = 0; i < film.cause.size(); ++i) {
    ++counts.pixels[static_cast<std::size_t>(film.cause[i])];
    if (!film.unfinished.empty() && film.unfinished[i]) continue;
    ++counts.finished;
    counts.ended_by_max += film.cause[i] == SplitCause::depth_limit;
  }
  return counts;
}

std::vector<LegendEntry> legend_entries(SplitMapColours colours, const CauseCounts& causes) {
  if (colours == SplitMapColours::rays || colours == SplitMapColours::time)
    return cost_entries(colours);
  std::vector<LegendEntry> entries;
  if (colours == SplitMapColours::cause) {
    for (std::size_t i = 1; i < split_cause_count; ++i)
      if (causes.pixels[i] > 0)
        entries.push_back({split_cause_colour(static_cast<SplitCause>(i)), split_cause_titles[i]});
    return entries;
  }
  entries.push_back({split_colour(0), "not split"});
  entries.push_back({exact_colour, "exact"});
  entries.push_back({sampled_colour, "sampled"});
  for (int level = 1; level <= split_colour_levels; ++level)
    entries.push_back({split_colour(level), std::to_string(level)});
  return entries;
}

void add_legend(RgbImage& image, SplitMapColours colours, const CauseCounts& causes) {
  const float em = ImGui::GetFont()->FontSize;
  const float row = 1.5f * em, swatch = 1.4f * em, gap = 0.4f * em;
  struct Place {
    LegendEntry entry;
    float x, y;
  };
  std::vector<Place> places;
  float x = gap, y = row;
  for (const LegendEntry& entry : legend_entries(colours, causes)) {
    const float width = swatch + gap + width_of(entry.words) + 2.0f * gap;
    if (x > gap && x + width > static_cast<float>(image.width)) {
      x = gap;
      y += row;
    }
    places.push_back({entry, x, y});
    x += width;
  }
  const int first_row = image.height;
  image.height += static_cast<int>(std::ceil(y + row));
  image.rgb.resize(
      3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
      strip_ground);
  Strip strip(image, first_row);
  const float above = 0.25f * em;
  strip.text(gap, above, legend_title(colours));
  for (const Place& place : places) {
    strip.fill(static_cast<int>(place.x), static_cast<int>(place.y + above),
               static_cast<int>(swatch), static_cast<int>(em), place.entry.colour);
    strip.text(place.x + swatch + gap, place.y + above, place.entry.words);
  }
}

}  // namespace asos::ui
