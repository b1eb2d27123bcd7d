#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

namespace asos {

namespace {

void camera_list(Controls& controls, Previewer& previewer, const std::vector<Camera>& cameras) {
  std::vector<std::string> names{"Whole scene"};
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    names.push_back(cameras[i].name.empty() ? fmt::format("Camera {}", i + 1) : cameras[i].name);
  }
  int chosen = previewer.chosen_camera() + 1;
  if (controls.list("View", "The cameras of the file, and a view that frames the whole scene.",
                    names, chosen)) {
    previewer.choose_camera(chosen - 1);
  }
}

}  // namespace

void camera_panel(Controls& controls, Previewer& previewer) {
  if (!previewer.scene() || !controls.section("Camera")) return;
  const std::vector<Camera>& cameras = previewer.scene()->world.cameras;
  if (!cameras.empty()) camera_list(controls, previewer, cameras);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (controls.button("Frame all",
                      "Move the camera so that everything is in the picture; the direction stays. "
                      "Keys: Home, F.",
                      width)) {
    previewer.frame_all();
  }
  ImGui::SameLine();
  if (controls.button("Reset view",
                      "Back to the view that the scene opened with, or that was chosen last.",
                      width)) {
    previewer.choose_camera(previewer.chosen_camera());
  }
}

}  // namespace asos
