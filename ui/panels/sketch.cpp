#include "ui/panels/sketch.h"

#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asos::ui {

namespace {

constexpr float units_across = 16.0f, units_down = 6.0f;

ImVec2 vec(glm::vec2 v) {
  return {v.x, v.y};
}

}  // namespace

Sketch::Sketch(float width) : unit_(width / units_across) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  lo_ = {corner.x, corner.y};
  const glm::vec2 size = unit_ * glm::vec2(units_across, units_down);
  ImGui::Dummy(vec(size));
  const bool dark = theme::look() == theme::Look::dark;
  ImGui::GetWindowDrawList()->AddRectFilled(
      corner, vec(lo_ + size),
      dark ? theme::packed(theme::plot_ground) : theme::packed(theme::field), 0.3f * unit_);
}

std::uint32_t Sketch::colour(Ink ink, float alpha) const {
  switch (ink) {
    case Ink::dim:
      return theme::packed(theme::dim_text, alpha);
    case Ink::accent:
      return theme::packed(theme::accent_bright, alpha);
    case Ink::warm:
      return theme::packed(theme::warning, alpha);
    case Ink::faint:
      return theme::packed(theme::line, alpha);
    case Ink::plain:
      break;
  }
  return theme::packed(theme::text, alpha);
}

void Sketch::line(glm::vec2 from, glm::vec2 to, Ink ink) const {
  ImGui::GetWindowDrawList()->AddLine(vec(at(from)), vec(at(to)), colour(ink),
                                      std::max(1.0f, 0.09f * unit_));
}

void Sketch::box(glm::vec2 lo, glm::vec2 hi, Ink ink) const {
  ImGui::GetWindowDrawList()->AddRect(vec(at(lo)), vec(at(hi)), colour(ink), 0.0f, 0,
                                      std::max(1.0f, 0.09f * unit_));
}

void Sketch::filled(glm::vec2 lo, glm::vec2 hi, Ink ink, float alpha) const {
  ImGui::GetWindowDrawList()->AddRectFilled(vec(at(lo)), vec(at(hi)), colour(ink, alpha));
}

void Sketch::disc(glm::vec2 middle, float radius, Ink ink, float alpha) const {
  ImGui::GetWindowDrawList()->AddCircleFilled(vec(at(middle)), radius * unit_, colour(ink, alpha));
}

void Sketch::ring(glm::vec2 middle, float radius, Ink ink) const {
  ImGui::GetWindowDrawList()->AddCircle(vec(at(middle)), radius * unit_, colour(ink), 0,
                                        std::max(1.0f, 0.09f * unit_));
}

void Sketch::shape(std::initializer_list<glm::vec2> corners, Ink ink, float alpha) const {
  std::vector<ImVec2> points;
  for (const glm::vec2 corner : corners) points.push_back(vec(at(corner)));
  ImGui::GetWindowDrawList()->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()),
                                                  colour(ink, alpha));
}

void Sketch::words(glm::vec2 middle, const char* text, Ink ink) const {
  const ImVec2 size = ImGui::CalcTextSize(text);
  const glm::vec2 place = at(middle) - 0.5f * glm::vec2(size.x, size.y);
  ImGui::GetWindowDrawList()->AddText({std::round(place.x), std::round(place.y)}, colour(ink),
                                      text);
}

void Sketch::split_square(glm::vec2 lo, float side, glm::vec2 towards, int levels) const {
  box(lo, lo + side);
  for (int level = 0; level < levels; ++level) {
    const glm::vec2 middle = lo + 0.5f * side;
    line({middle.x, lo.y}, {middle.x, lo.y + side}, Ink::dim);
    line({lo.x, middle.y}, {lo.x + side, middle.y}, Ink::dim);
    lo += 0.5f * side * glm::vec2(towards.x > middle.x, towards.y > middle.y);
    side *= 0.5f;
  }
}

void draw_pyray(const Sketch& sketch) {
  using Ink = Sketch::Ink;
  const glm::vec2 eye(1.4f, 3.0f);
  sketch.disc(eye, 0.3f, Ink::plain);
  sketch.shape({eye, {12.2f, 1.0f}, {12.2f, 5.0f}}, Ink::accent, 0.2f);
  for (const float y : {1.0f, 5.0f}) sketch.line(eye, {12.2f, y}, Ink::accent);
  sketch.line({5.2f, 0.8f}, {5.2f, 5.2f}, Ink::dim);
  sketch.line({5.2f, 2.3f}, {5.2f, 3.7f}, Ink::accent);
  sketch.shape({{12.2f, 0.5f}, {13.4f, 0.5f}, {12.8f, 3.4f}, {12.2f, 3.4f}}, Ink::warm);
  sketch.line({12.2f, 0.5f}, {12.2f, 5.5f}, Ink::dim);
  sketch.words({1.4f, 4.2f}, "eye");
  sketch.words({7.3f, 0.7f}, "picture");
  sketch.words({14.4f, 4.4f}, "scene");
}

}  // namespace asos::ui
