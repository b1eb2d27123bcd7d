#include "ui/input.h"
#include "ui/panels/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

// A drag over the whole height turns by half a circle, for any window size.
constexpr double orbit_rad_per_height = std::numbers::pi;
constexpr double look_rad_per_height = 0.4 * std::numbers::pi;
constexpr double dolly_per_step = 0.88;

glm::vec2 vec(ImVec2 v) {
  return {v.x, v.y};
}

// Flying speed in the scene's radii per second; Shift multiplies it by four.
constexpr double fly_radii_per_second = 0.4;
constexpr double fast = 4.0;
// A press that moves less than this, in window units, is a click.
constexpr float click_distance = 4.0f;

bool held(Key key) {
  return ImGui::IsKeyDown(static_cast<int>(key));
}

// Flies while the right button is down and the whole picture is visible.
void fly(OrbitCamera& camera) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto axis = [](Key plus, Key minus) {
    return static_cast<double>(held(plus)) - static_cast<double>(held(minus));
  };
  const glm::dvec3 way(axis(Key::d, Key::a), axis(Key::e, Key::q), axis(Key::w, Key::s));
  if (way == glm::dvec3(0.0)) return;
  // Limits the step of a late frame, as after the window slept.
  const double seconds = std::min(static_cast<double>(io.DeltaTime), 0.1);
  const glm::dvec3 by = seconds * fly_radii_per_second * (io.KeyShift ? fast : 1.0) * way;
  camera.fly(by.x, by.y, by.z);
}

void drag(Previewer& previewer, UiState& state, glm::vec2 delta, float area_height) {
  const ImGuiIO& io = ImGui::GetIO();
  PictureView& view = state.view;
  OrbitCamera& camera = previewer.viewpoint().camera();
  const bool left = io.MouseDown[0], right = io.MouseDown[1], middle = io.MouseDown[2];
  if (right && state.turns_surroundings) {
    // The angle that makes the horizon ahead follow the pointer.
    SceneEdits& edits = previewer.edits();
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(area_height);
    edits.turn_surroundings(-orbit_rad_per_height * heights.x);
    // A drag of half the height doubles the brightness.
    if (const Sky* sky = edits.settings().sky.get(); sky && heights.y != 0.0)
      edits.brighten_sky(std::min(sky->choice().brightness * std::exp2(-2.0 * heights.y),
                                  SkyChoice::most_brightness));
  } else if (right && view.zoom() > 1) {
    view.pan(delta);
  } else if (right) {
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(area_height);
    camera.look_around(-look_rad_per_height * heights.x, -look_rad_per_height * heights.y);
  }
  if (middle || (left && io.KeyShift)) {
    const float picture_height =
        view.scale() * static_cast<float>(previewer.render().film().height);
    if (picture_height <= 0.0f) return;
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(picture_height);
    camera.pan(heights.x, heights.y);
  } else if (left) {
    const glm::dvec2 heights = glm::dvec2(delta) / static_cast<double>(area_height);
    camera.orbit(-orbit_rad_per_height * heights.x, orbit_rad_per_height * heights.y);
  }
}

// Drags the frame of the part that is refined first.
void drag_part(PreviewRender& render, const PictureView& view, glm::vec2 from, glm::vec2 to) {
  const Film& film = render.film();
  const glm::vec2 a = view.picture_from_area(from), b = view.picture_from_area(to);
  const glm::ivec2 lo(glm::floor(glm::min(a, b))), hi(glm::ceil(glm::max(a, b)));
  render.prefer(
      intersection({lo.x, lo.y, hi.x - lo.x, hi.y - lo.y}, {0, 0, film.width, film.height}));
}

void pick(UiState& state, std::optional<glm::ivec2> pixel) {
  state.picked = pixel;
  state.picked_pyray = -1;
  state.shown_level.reset();
}

std::optional<glm::ivec2> picked_pixel(const PictureView& view, glm::vec2 pointer,
                                       const Film& film) {
  const glm::ivec2 pixel(glm::floor(view.picture_from_area(pointer)));
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < film.width && pixel.y < film.height;
  return inside ? std::optional(pixel) : std::nullopt;
}

void clicked(Previewer& previewer, UiState& state, glm::vec2 pointer) {
  const std::optional<glm::ivec2> pixel =
      picked_pixel(state.view, pointer, previewer.render().film());
  if (std::exchange(state.lens.click_to_focus, false)) {
    if (pixel) previewer.viewpoint().focus_at(pixel->x + 0.5, pixel->y + 0.5);
    return;
  }
  // A click selects the object. Another one on it, or with Ctrl, inspects the pixel.
  const int part = pixel && previewer.scene() ? object_at(previewer, *pixel) : -1;
  const std::vector<int> selected = selected_objects(previewer.scene(), state.outline);
  const bool again =
      part < 0 ? selected.empty() : std::binary_search(selected.begin(), selected.end(), part);
  if (state.picked || again || ImGui::GetIO().KeyCtrl) pick(state, pixel);
  state.clicked = pixel;
  state.outline.followed.reset();  // the same pixel may be clicked again
}

}  // namespace

bool flying() {
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Right)) return false;
  return held(Key::w) || held(Key::a) || held(Key::s) || held(Key::d) || held(Key::q) ||
         held(Key::e);
}

void picture_area(Controls& controls, Previewer& previewer, UiState& state,
                  const PictureArea& place) {
  const WindowRect& area = place.rect;
  const float framebuffer_scale = place.scale;
  PictureView& view = state.view;
  if (area.size.x < 1.0f || area.size.y < 1.0f) return;
  ImGui::SetCursorScreenPos({area.lo.x, area.lo.y});
  ImGui::InvisibleButton("picture", {area.size.x, area.size.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  controls.placed("Picture", nullptr);

  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 pointer = (vec(io.MousePos) - area.lo) * framebuffer_scale;
  const glm::vec2 delta = vec(io.MouseDelta) * framebuffer_scale;
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
    state.turns_surroundings = io.KeyShift && !flying();
  const bool marks_part = state.marks_part || (held(Key::z) && !io.KeyCtrl);
  if (ImGui::IsItemActive() && delta != glm::vec2(0.0f)) {
    const glm::vec2 from = (vec(io.MouseClickedPos[0]) - area.lo) * framebuffer_scale;
    if (marks_part && io.MouseDown[0])
      drag_part(previewer.render(), view, from, pointer);
    else
      drag(previewer, state, delta, area.size.y * framebuffer_scale);
  }
  if (ImGui::IsItemActive() && io.MouseDown[1] && view.zoom() == 1 && !state.turns_surroundings)
    fly(previewer.viewpoint().camera());
  if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
      io.MouseDragMaxDistanceSqr[0] < click_distance * click_distance && !state.marks_part)
    clicked(previewer, state, pointer);
  if (ImGui::IsItemDeactivated()) state.marks_part = false;
  state.hovered.reset();
  if (!ImGui::IsItemHovered()) return;
  state.hovered = picked_pixel(view, pointer, previewer.render().film());
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    const glm::vec2 at = view.picture_from_area(pointer);
    previewer.viewpoint().set_pivot_at(static_cast<double>(at.x), static_cast<double>(at.y));
  }
  if (io.MouseWheel != 0.0f) {
    if (io.KeyCtrl) {
      view.zoom_at(pointer, io.MouseWheel > 0.0f ? 1 : -1);
    } else {
      previewer.viewpoint().camera().dolly(
          std::pow(dolly_per_step, static_cast<double>(io.MouseWheel)));
    }
  }
}

}  // namespace asos::ui
