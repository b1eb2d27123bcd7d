#include "ui/panels/panels.h"

#include <fmt/format.h>

namespace asos {

void camera_panel(Controls& controls, Previewer& previewer) {
  if (!previewer.scene() || !controls.section("Camera")) return;
  const std::vector<Camera>& cameras = previewer.scene()->world.cameras;
  std::vector<std::string> names{"Whole scene"};
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    names.push_back(cameras[i].name.empty() ? fmt::format("Camera {}", i + 1) : cameras[i].name);
  }
  int chosen = previewer.chosen_camera() + 1;
  if (controls.list("View", "The cameras of the file, and a view that frames the whole scene.",
                    names, chosen)) {
    previewer.choose_camera(chosen - 1);
  }
  if (controls.button("Frame all",
                      "Move the camera so that everything is in the picture; the direction stays. "
                      "Keys: Home, F.",
                      -1.0f)) {
    previewer.frame_all();
  }
}

}  // namespace asos
