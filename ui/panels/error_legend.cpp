#include "renderer/files/counted.h"
#include "renderer/film/split_map.h"
#include "ui/error_map.h"
#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

namespace asos::ui {

namespace {

constexpr float error_legend_width_em = 24.0f;

struct ErrorTick {
  double steps;
  const char* text;
};
constexpr std::array error_ticks{ErrorTick{0.25, "1/4"}, ErrorTick{1.0, "1 step"},
                                 ErrorTick{4.0, "4"}, ErrorTick{16.0, "16"},
                                 ErrorTick{64.0, "64 steps"}};

void error_scale(Controls& controls) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.9f * em;
  constexpr int steps = 128;
  for (int i = 0; i < steps; ++i) {
    const float from = static_cast<float>(i) / steps, to = static_cast<float>(i + 1) / steps;
    const glm::u8vec3 c = heat_colour(0.5f * (from + to));
    draw->AddRectFilled({corner.x + from * width, corner.y},
                        {corner.x + to * width, corner.y + height}, IM_COL32(c.x, c.y, c.z, 255));
  }
  std::string words;
  for (const ErrorTick& tick : error_ticks) {
    words += (words.empty() ? "" : " ") + std::string(tick.text);
    const float x = corner.x + ErrorScale::share(tick.steps) * width;
    const float text = ImGui::CalcTextSize(tick.text).x;
    draw->AddText({std::clamp(x - 0.5f * text, corner.x, corner.x + width - text),
                   corner.y + height + 0.25f * em},
                  theme::packed(theme::dim_text), tick.text);
  }
  draw->AddRect(corner, {corner.x + width, corner.y + height}, theme::packed(theme::line));
  ImGui::Dummy({width, height + 1.4f * em});
  controls.placed_words(
      "Error scale", words,
      "Error per pixel in 8-bit display steps, logarithmic. Black: less than 1/4.");
}

}  // namespace

void error_legend(Controls& controls, const ErrorFacts& facts, const WindowRect& area) {
  const float em = ImGui::GetFontSize();
  const float width = std::min(error_legend_width_em * em, area.size.x - em);
  if (width < 8.0f * em || area.size.y < 6.0f * em) return;
  ImGui::SetNextWindowPos({area.lo.x + 0.5f * em, area.lo.y + area.size.y - 0.5f * em},
                          ImGuiCond_Always, {0.0f, 1.0f});
  ImGui::SetNextWindowSize({width, 0.0f});
  ImGui::SetNextWindowBgAlpha(0.96f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.3f * em);
  ImGui::Begin("error legend", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::TextUnformatted("Error per pixel");
  error_scale(controls);
  std::string words = "Sampling the reference";
  if (facts.samples > 0)
    words =
        "Reference: " + counted(static_cast<std::uint64_t>(facts.samples), "sample") + " per pixel";
  else if (!facts.finished)
    words = "Reference: when the picture is finished";
  ImGui::TextDisabled("%s", words.c_str());
  controls.placed_words("Error reference", words, "It is kept while EPS, MAX and method change.");
  controls.placed_window("Error legend");
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace asos::ui
