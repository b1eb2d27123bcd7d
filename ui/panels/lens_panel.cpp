#include "ui/panels/lens_panel.h"

#include "renderer/comparison/method.h"
#include "renderer/prepared/focus.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

// Blur of points at infinity when a lens is switched on, in picture heights.
constexpr double usual_blur = 0.01;

constexpr std::array aperture_corners{0, 3, 4, 5, 6, 7, 8, 9, 12, 16};

// No photographic lens is as wide as its focal length is long twice.
constexpr double widest_named = 0.5;

std::string aperture_words(double f_stop, double fov_y_rad) {
  if (f_stop >= widest_named) return fmt::format("f/{:.3g}", f_stop);
  return fmt::format("{:.2g} units wide", 2.0 * aperture_of_f_stop(f_stop, fov_y_rad));
}

void aperture_controls(Controls& controls, const Camera& camera, Lens& lens) {
  double f_stop = f_stop_of_aperture(lens.radius, camera.fov_y_rad);
  if (controls.number("Aperture",
                      fmt::format("f-stop of a 24 mm sensor in metres. Radius: {} scene units.",
                                  number_words(lens.radius))
                          .c_str(),
                      f_stop, {{Lens::smallest_f_stop, Lens::largest_f_stop, {}}, 0.01, true},
                      [&](double n) { return aperture_words(n, camera.fov_y_rad); }))
    lens.radius = aperture_of_f_stop(f_stop, camera.fov_y_rad);
  std::vector<std::string> names;
  for (const int corners : aperture_corners)
    names.push_back(corners == 0 ? "Disk" : fmt::format("{} blades", corners));
  const auto at = std::find(aperture_corners.begin(), aperture_corners.end(), lens.blades);
  int chosen = at == aperture_corners.end() ? -1 : static_cast<int>(at - aperture_corners.begin());
  if (controls.list("Blades", "Shape of highlights that are out of focus.", names, chosen, 0))
    lens.blades = aperture_corners[static_cast<std::size_t>(chosen)];
  if (lens.blades == 0) return;
  controls.angle_slider("Blade turn", "Turn of the aperture in degrees.", lens.turn_rad,
                        {-180.0, 180.0, 0.0},
                        [](float deg) { return fmt::format("{:.0f}\u00b0", deg); });
}

void focus_controls(Controls& controls, const Camera& focused, Lens& lens, LensState& choice) {
  bool automatic = !lens.focus;
  if (controls.checkbox("Auto focus", "Focus on the middle of the picture.", automatic, true))
    lens.focus = automatic ? std::nullopt : focused.lens.focus;
  double distance = focused.lens.focus.value_or(1.0);
  if (controls.number("Focus", "Distance of the sharp plane from the camera, in scene units.",
                      distance, {{1e-6 * distance, 1e6 * distance, {}}, 1e-4 * distance, true},
                      number_words))
    lens.focus = distance;
  if (controls.button(choice.click_to_focus ? "Click the picture..." : "Click to focus",
                      "The next click into the picture sets the focus.", -1.0f))
    choice.click_to_focus = !choice.click_to_focus;
}

}  // namespace

void lens_panel(Controls& controls, Previewer& previewer, LensState& choice) {
  OrbitCamera& orbit = previewer.viewpoint().camera();
  const Camera camera = orbit.camera();
  if (!previewer.scene() || camera.type != Camera::Type::perspective) {
    choice.click_to_focus = false;
    return;
  }
  if (!controls.section("Lens", false)) return;
  Lens lens = camera.lens;
  bool on = lens.blurs();
  if (controls.checkbox("Depth of field", "Blur what is out of focus.", on, false))
    lens.radius = on ? 2.0 * usual_blur * std::tan(0.5 * camera.fov_y_rad) * orbit.distance() : 0.0;
  if (lens.blurs()) {
    Camera blurred = camera;
    blurred.lens = lens;
    aperture_controls(controls, camera, lens);
    focus_controls(controls, focused(*previewer.scene(), blurred, previewer.edits().settings()),
                   lens, choice);
    if (!row_of(previewer.edits().settings().method).takes_lens)
      controls.row("Note", "This method renders without blur.");
  } else {
    choice.click_to_focus = false;
  }
  if (!(lens == camera.lens)) orbit.set_lens(lens);
}

}  // namespace asos::ui
