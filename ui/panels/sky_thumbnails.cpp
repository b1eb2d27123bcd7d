#include "ui/panels/sky_thumbnails.h"

#include "renderer/film/tone.h"
#include "renderer/shading/environment_picture.h"
#include "renderer/shading/environments.h"
#include "renderer/shading/sky.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>

namespace asos::ui {

namespace {

constexpr int panorama_columns = 24, panorama_rows = 10, thumbnails_a_row = 4;
// Largest elevation shown.
constexpr double highest_rad = 1.3;

/// Colours at the corners of the cells, from the upper left. The centre faces -Z, like a default
/// camera.
using Panorama = std::array<std::uint32_t, (panorama_columns + 1) * (panorama_rows + 1)>;

Panorama panorama_of(Environment environment) {
  Panorama panorama{};
  for (int y = 0; y <= panorama_rows; ++y) {
    for (int x = 0; x <= panorama_columns; ++x) {
      const double turn = 2.0 * std::numbers::pi * x / panorama_columns;
      const double elevation = highest_rad * (1.0 - 2.0 * y / panorama_rows);
      const glm::dvec3 d(-std::sin(turn) * std::cos(elevation), std::sin(elevation),
                         std::cos(turn) * std::cos(elevation));
      const glm::vec3 shown =
          tone_mapped(environment_radiance(environment, d), {0.0f, ToneCurve::neutral});
      const auto byte = [](float linear) {
        return static_cast<int>(255.0f * std::pow(std::clamp(linear, 0.0f, 1.0f), 1.0f / 2.2f));
      };
      panorama[static_cast<std::size_t>(y * (panorama_columns + 1) + x)] =
          IM_COL32(byte(shown.x), byte(shown.y), byte(shown.z), 255);
    }
  }
  return panorama;
}

const Panorama& panorama(std::size_t row) {
  static const std::array<Panorama, environments.size()> all = [] {
    std::array<Panorama, environments.size()> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = panorama_of(environments[i].value);
    return made;
  }();
  return all[row];
}

void draw_panorama(const Panorama& colours, ImVec2 lo, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto at = [&](int x, int y) {
    return ImVec2{lo.x + size.x * static_cast<float>(x) / panorama_columns,
                  lo.y + size.y * static_cast<float>(y) / panorama_rows};
  };
  const auto colour = [&](int x, int y) {
    return colours[static_cast<std::size_t>(y * (panorama_columns + 1) + x)];
  };
  for (int y = 0; y < panorama_rows; ++y)
    for (int x = 0; x < panorama_columns; ++x)
      list.AddRectFilledMultiColor(at(x, y), at(x + 1, y + 1), colour(x, y), colour(x + 1, y),
                                   colour(x + 1, y + 1), colour(x, y + 1));
}

bool thumbnail(Controls& controls, std::size_t index, bool chosen, float width) {
  const EnvironmentRow& row = environments[index];
  const ImVec2 lo = ImGui::GetCursorScreenPos(), size{width, std::round(0.5f * width)};
  ImGui::BeginGroup();
  ImGui::PushID(static_cast<int>(index));
  const bool pressed = ImGui::InvisibleButton("environment", size);
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
  controls.placed(std::string("Environment/") + row.name, row.hint, Controls::Use::edits);
  draw_panorama(panorama(index), lo, size);
  if (chosen || hovered)
    ImGui::GetWindowDrawList()->AddRect(lo, {lo.x + size.x, lo.y + size.y},
                                        theme::packed(chosen ? theme::accent_bright : theme::text),
                                        0.0f, 0, 2.0f);
  ImGui::TextDisabled("%s", row.name);
  ImGui::EndGroup();
  return pressed;
}

}  // namespace

void sky_thumbnails(Controls& controls, SceneEdits& edits) {
  const Sky* sky = edits.settings().sky.get();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - (thumbnails_a_row - 1) * gap) /
                                 static_cast<float>(thumbnails_a_row));
  if (width < 8.0f) return;
  for (std::size_t i = 0; i < environments.size(); ++i) {
    if (i % thumbnails_a_row != 0) ImGui::SameLine();
    const bool chosen = sky && sky->choice().environment == environments[i].value;
    if (thumbnail(controls, i, chosen, width) && !chosen) {
      edits.set_sky(std::make_shared<const Sky>(environments[i].value));
      sky = edits.settings().sky.get();
    }
  }
}

}  // namespace asos::ui
