#include "renderer/files/counted.h"
#include "ui/error_map.h"
#include "ui/panels/heat_strip.h"
#include "ui/panels/overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

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
  std::vector<HeatTick> ticks;
  std::string words;
  for (const ErrorTick& tick : error_ticks) {
    words += (words.empty() ? "" : " ") + std::string(tick.text);
    ticks.push_back({ErrorScale::share(tick.steps), tick.text});
  }
  heat_strip(ticks);
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
