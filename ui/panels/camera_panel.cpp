#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>
#include <vector>

namespace asos {

namespace {

void camera_list(Controls& controls, Viewpoint& viewpoint, const std::vector<Camera>& cameras) {
  std::vector<std::string> names{"Whole scene"};
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    names.push_back(cameras[i].name.empty() ? fmt::format("Camera {}", i + 1) : cameras[i].name);
  }
  // A camera that was left is not shown any more, and may be chosen again.
  int chosen = viewpoint.left_chosen() ? -1 : viewpoint.chosen_camera() + 1;
  if (controls.list("View",
                    "The cameras of the file, and a view that frames the whole scene. Empty: the "
                    "camera has been moved.",
                    names, chosen)) {
    viewpoint.choose_camera(chosen - 1);
  }
}

}  // namespace

void camera_panel(Controls& controls, Previewer& previewer) {
  if (!previewer.scene() || !controls.section("Camera")) return;
  Viewpoint& viewpoint = previewer.viewpoint();
  const std::vector<Camera>& cameras = previewer.scene()->world().cameras;
  if (!cameras.empty()) camera_list(controls, viewpoint, cameras);
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (controls.button("Frame all",
                      "Move the camera so that everything is in the picture; the direction stays. "
                      "Keys: Home, F.",
                      width)) {
    viewpoint.frame_all();
  }
  ImGui::SameLine();
  if (controls.button("Reset view",
                      "Back to the view that the scene opened with, or that was chosen last.",
                      width)) {
    viewpoint.choose_camera(viewpoint.chosen_camera());
  }
}

}  // namespace asos
