#include "ui/panels/grid_overlay.h"

#include "renderer/world/ground.h"
#include "ui/panels/projection.h"

#include <array>
#include <cmath>

namespace asos {

namespace {

constexpr int most_lines = 40;  // to either side

// Told apart by the colour-blind, too (Okabe and Ito).
constexpr std::array<std::uint32_t, 3> axis_colours{
    IM_COL32(213, 94, 0, 220), IM_COL32(0, 158, 115, 220), IM_COL32(86, 180, 233, 220)};
constexpr std::array axis_names{"X", "Y", "Z"};

/// Dark with a pale middle is seen before every background.
void two_tone_line(const Projection& on, glm::dvec3 a, glm::dvec3 b) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  on.line(draw, a, b, IM_COL32(0, 0, 0, 70), 2.0f);
  on.line(draw, a, b, IM_COL32(255, 255, 255, 90), 1.0f);
}

/// Parallel to X and Z, at whole multiples of the step of the author's coordinates, around the
/// middle of what is seen.
void draw_grid(const Projection& on, const Box& bounds, glm::dvec3 origin, double radius) {
  const double step = grid_step(radius);
  const glm::dvec3 middle = 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi));
  const double height = static_cast<double>(bounds.lo.y);
  const int lines = std::min(most_lines, static_cast<int>(std::ceil(1.5 * radius / step)));
  const auto at_multiple = [&](int axis) {
    return step * std::round((middle[axis] + origin[axis]) / step) - origin[axis];
  };
  const glm::dvec3 centre(at_multiple(0), height, at_multiple(2));
  const double reach = lines * step;
  for (int i = -lines; i <= lines; ++i) {
    const double by = i * step;
    two_tone_line(on, centre + glm::dvec3(by, 0, -reach), centre + glm::dvec3(by, 0, reach));
    two_tone_line(on, centre + glm::dvec3(-reach, 0, by), centre + glm::dvec3(reach, 0, by));
  }
}

void draw_axes(const Projection& on, glm::dvec3 origin, double length) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 tip = -origin;
    tip[axis] += length;
    const std::uint32_t colour = axis_colours[static_cast<std::size_t>(axis)];
    on.line(draw, -origin, tip, colour, 2.5f);
    const glm::dvec3 h = on.homogeneous(tip);
    if (on.visible(h))
      draw.AddText(on.window(h), colour, axis_names[static_cast<std::size_t>(axis)]);
  }
}

}  // namespace

double grid_step(double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) return 0.0;
  const double wanted = radius / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double times : {1.0, 2.0, 5.0})
    if (wanted <= times * power) return times * power;
  return 10.0 * power;
}

void grid_overlay(const Previewer& previewer, const PictureView& view, const PictureArea& area) {
  const Film& film = previewer.render().film();
  if (!previewer.scene() || film.width <= 0) return;
  const World& world = previewer.scene()->world();
  const Box bounds = bounds_without_ground(world);
  if (bounds.empty()) return;
  const double radius = 0.5 * glm::length(glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo));
  if (!(grid_step(radius) > 0.0)) return;
  const Projection on(previewer.viewpoint(), film, view, area);
  draw_grid(on, bounds, world.origin, radius);
  draw_axes(on, world.origin, radius);
}

}  // namespace asos
