#include "ui/camera_text.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

void camera_list(Controls& controls, Viewpoint& viewpoint, const std::vector<Camera>& cameras) {
  std::vector<std::string> names{"Whole scene"};
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    names.push_back(cameras[i].name.empty() ? fmt::format("Camera {}", i + 1) : cameras[i].name);
  }
  // A camera that the user has moved away from is shown as not chosen, so it can be chosen again.
  int chosen = viewpoint.left_chosen() ? -1 : viewpoint.chosen_camera() + 1;
  if (controls.list(
          "View",
          "Cameras of the file, and a view of the whole scene. Empty: the camera was moved.", names,
          chosen)) {
    viewpoint.choose_camera(chosen - 1);
  }
}

void view_buttons(Controls& controls, Viewpoint& viewpoint) {
  const int view =
      controls.buttons({{"Frame all", "Fit the whole scene into the picture (Home, F)."},
                        {"Reset view", "Restore the view of the start or the chosen camera."}});
  if (view == 0) viewpoint.frame_all();
  if (view == 1) viewpoint.choose_camera(viewpoint.chosen_camera());
  constexpr std::array sides{Viewpoint::Side::front, Viewpoint::Side::right, Viewpoint::Side::top};
  const int side =
      controls.buttons({{"Front", "View along -Z (keypad 1). From behind: Ctrl+keypad 1."},
                        {"Right", "View along -X (keypad 3). From the left: Ctrl+keypad 3."},
                        {"Top", "View from above (keypad 7). From below: Ctrl+keypad 7."}});
  if (side >= 0) viewpoint.look_from(sides[static_cast<std::size_t>(side)]);
}

constexpr std::array projections{
    Controls::Option{"Perspective", "Distant objects look smaller (keypad 5)."},
    Controls::Option{"Orthographic", "Distant objects keep their size (keypad 5)."},
};

void lens_controls(Controls& controls, OrbitCamera& camera) {
  const Camera now = camera.camera();
  int chosen = now.type == Camera::Type::perspective ? 0 : 1;
  if (controls.options("Projection", projections, chosen, {false, std::nullopt}))
    camera.set_projection(chosen == 0 ? Camera::Type::perspective : Camera::Type::orthographic);
  if (chosen == 1) return;
  double fov_y_rad = now.fov_y_rad;
  if (controls.angle_slider("Field of view", "Vertical field of view in degrees.", fov_y_rad,
                            {1.0, 170.0, 45.0}))
    camera.set_fov_y(fov_y_rad);
}

std::string planes_text(const Camera& camera) {
  const auto at = [](const char* name, const std::optional<double>& depth) {
    return depth ? fmt::format(" {} {:.4g}", name, *depth) : std::string();
  };
  return "Hides surfaces nearer or farther than the camera's planes:" +
         at("near", camera.near_depth) + at("far", camera.far_depth) + ".";
}

void planes_control(Controls& controls, Viewpoint& viewpoint) {
  const OrbitCamera& camera = viewpoint.camera();
  if (!camera.has_planes()) return;
  bool on = camera.planes();
  if (controls.checkbox("Clip at planes", planes_text(camera.lens()).c_str(), on, true))
    viewpoint.set_planes(on);
}

void turntable_controls(Controls& controls, Turntable& turntable) {
  bool turning = turntable.turning();
  if (controls.checkbox("Turntable", "Circle the orbit centre until you move the camera (T).",
                        turning, false))
    turntable.set_turning(turning);
  if (!turning) return;
  controls.number(
      "Turn time", "Seconds per turn. Ctrl+click to type a value.", turntable.seconds_a_turn,
      {{Turntable::fastest, Turntable::slowest, Turntable{}.seconds_a_turn}, 0.01, true},
      [](double s) { return fmt::format("{:.3g} s", s); });
}

void copy_buttons(Controls& controls, const OrbitCamera& camera, glm::dvec3 origin) {
  const std::string options = camera_options(camera.camera(), camera.pivot(), origin);
  const int pressed = controls.buttons(
      {{"Copy options", options.empty()
                            ? "Only a perspective camera has command-line options."
                            : "Copy this view as --look-at and --fov. They have no roll."},
       {"Copy as glTF", "Copy this camera as a glTF file with one node."}});
  if (pressed == 0 && !options.empty()) ImGui::SetClipboardText(options.c_str());
  if (pressed == 1) ImGui::SetClipboardText(camera_as_gltf(camera.camera(), origin).c_str());
}

}  // namespace

void camera_panel(Controls& controls, Previewer& previewer) {
  if (!previewer.scene() || !controls.section("Camera")) return;
  Viewpoint& viewpoint = previewer.viewpoint();
  const std::vector<Camera>& cameras = previewer.scene()->world().cameras;
  if (!cameras.empty()) camera_list(controls, viewpoint, cameras);
  view_buttons(controls, viewpoint);
  copy_buttons(controls, viewpoint.camera(), previewer.scene()->world().origin);
  lens_controls(controls, viewpoint.camera());
  planes_control(controls, viewpoint);
  turntable_controls(controls, previewer.turntable());
}

}  // namespace asos::ui
