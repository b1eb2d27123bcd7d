#include "ui/panels/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {

namespace {

// Dragging over the whole height turns by half a circle, whatever the window's size.
constexpr double orbit_rad_per_height = std::numbers::pi;
constexpr double dolly_per_step = 0.88;

glm::vec2 vec(ImVec2 v) {
  return {v.x, v.y};
}

void drag(Previewer& previewer, PictureView& view, glm::vec2 delta, float area_height) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool left = io.MouseDown[0], right = io.MouseDown[1], middle = io.MouseDown[2];
  if (right) view.pan(delta);
  if (middle || (left && io.KeyShift)) {
    const float picture_height = view.scale() * static_cast<float>(previewer.film().height);
    if (picture_height <= 0.0f) return;
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(picture_height);
    previewer.camera().pan(heights.x, heights.y);
  } else if (left) {
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(area_height);
    previewer.camera().orbit(-orbit_rad_per_height * heights.x, orbit_rad_per_height * heights.y);
  }
}

}  // namespace

void picture_area(Controls& controls, Previewer& previewer, PictureView& view,
                  const WindowRect& area, float framebuffer_scale) {
  if (area.size.x < 1.0f || area.size.y < 1.0f) return;
  ImGui::SetCursorScreenPos({area.lo.x, area.lo.y});
  ImGui::InvisibleButton("picture", {area.size.x, area.size.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  controls.placed("Picture", nullptr);

  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 pointer = (vec(io.MousePos) - area.lo) * framebuffer_scale;
  const glm::vec2 delta = vec(io.MouseDelta) * framebuffer_scale;
  if (ImGui::IsItemActive() && delta != glm::vec2(0.0f)) {
    drag(previewer, view, delta, area.size.y * framebuffer_scale);
  }
  if (!ImGui::IsItemHovered()) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    const glm::vec2 at = view.picture_from_area(pointer);
    previewer.set_pivot_at(static_cast<double>(at.x), static_cast<double>(at.y));
  }
  if (io.MouseWheel != 0.0f) {
    if (io.KeyCtrl) {
      view.zoom_at(pointer, io.MouseWheel > 0.0f ? 1 : -1);
    } else {
      previewer.camera().dolly(std::pow(dolly_per_step, static_cast<double>(io.MouseWheel)));
    }
  }
}

}  // namespace asos
