#include "ui/panels/grid_overlay.h"

#include "renderer/world/ground.h"
#include "ui/panels/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

constexpr int most_lines = 40;  // to either side

// Colours that colour-blind users can distinguish (Okabe and Ito).
constexpr std::array<std::uint32_t, 3> axis_colours{
    IM_COL32(213, 94, 0, 220), IM_COL32(0, 158, 115, 220), IM_COL32(86, 180, 233, 220)};
constexpr std::array axis_names{"X", "Y", "Z"};

/// A dark line with a pale centre is visible on every background.
void two_tone_line(const Projection& on, glm::dvec3 a, glm::dvec3 b) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  on.line(draw, a, b, IM_COL32(0, 0, 0, 70), 2.0f);
  on.line(draw, a, b, IM_COL32(255, 255, 255, 90), 1.0f);
}

std::uint32_t paled(std::uint32_t colour) {
  constexpr std::uint32_t alpha = 70;
  return (colour & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

double radius_of(const Box& bounds) {
  return bounds.empty() ? 0.0 : 0.5 * glm::length(glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo));
}

/// Calls `line` for each grid line. Lines are parallel to X and Z, at multiples of the step in the
/// author's coordinates, around the centre of `bounds`.
template <typename Line>
void each_grid_line(const Box& bounds, glm::dvec3 origin, double radius, Line&& line) {
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
    line(centre + glm::dvec3(by, 0, -reach), centre + glm::dvec3(by, 0, reach));
    line(centre + glm::dvec3(-reach, 0, by), centre + glm::dvec3(reach, 0, by));
  }
}

void draw_axis(const Projection& on, const std::vector<LinePart>& parts, glm::dvec3 tip,
               std::size_t axis) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::uint32_t colour = axis_colours[axis];
  for (const LinePart& part : parts)
    on.line(draw, part.from, part.to, part.hidden ? paled(colour) : colour, 2.5f);
  const glm::dvec3 h = on.homogeneous(tip);
  if (on.visible(h)) draw.AddText(on.window(h), colour, axis_names[axis]);
}

}  // namespace

void axes_widget(Controls& controls, Viewpoint& viewpoint, const PictureArea& area) {
  using Side = Viewpoint::Side;
  constexpr float least_width_em = 40.0f, least_height_em = 16.0f;
  const float em = ImGui::GetFontSize(), length = 1.9f * em, radius = 0.55f * em;
  const WindowRect& rect = area.rect;
  if (rect.size.x < least_width_em * em || rect.size.y < least_height_em * em) return;
  const glm::vec2 centre = rect.lo + glm::vec2(rect.size.x - 3.0f * em, 3.0f * em);
  struct End {
    std::size_t axis;
    bool positive;
    Side side;
    glm::vec3 at{0.0f};  // right, up, towards the viewer
  };
  std::array ends{End{0, true, Side::right}, End{0, false, Side::left},
                  End{1, true, Side::top},   End{1, false, Side::bottom},
                  End{2, true, Side::front}, End{2, false, Side::back}};
  const glm::dmat3 camera(viewpoint.camera().camera().world_from_camera);
  for (End& end : ends)
    for (int k = 0; k < 3; ++k)
      end.at[k] =
          static_cast<float>((end.positive ? 1.0 : -1.0) * camera[k][static_cast<int>(end.axis)]);
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.at.z > b.at.z; });
  const auto place = [&](const End& end) {
    return centre + length * glm::vec2(end.at.x, -end.at.y);
  };
  // The nearest end takes the click.
  for (const End& end : ends) {
    const std::string name =
        std::string("Axis/") + (end.positive ? "" : "-") + axis_names[end.axis];
    ImGui::SetCursorScreenPos({place(end).x - radius, place(end).y - radius});
    if (ImGui::InvisibleButton(name.c_str(), {2.0f * radius, 2.0f * radius}))
      viewpoint.look_from(end.side);
    controls.placed(name, "Look along this axis.", Controls::Use::edits);
  }
  ImGui::SetCursorScreenPos({centre.x - 2.5f * em, centre.y - 2.5f * em});
  ImGui::InvisibleButton("axes", {5.0f * em, 5.0f * em});
  controls.placed("Axes turn", "Drag to orbit.", Controls::Use::edits);
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (ImGui::IsItemActive() && (by.x != 0.0f || by.y != 0.0f))
    viewpoint.camera().orbit(-static_cast<double>(by.x / length),
                             static_cast<double>(by.y / length));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    draw.AddCircleFilled({centre.x, centre.y}, 2.5f * em, IM_COL32(128, 128, 128, 60));
  std::reverse(ends.begin(), ends.end());
  for (const End& end : ends) {
    const ImVec2 tip{place(end).x, place(end).y};
    const std::uint32_t colour = axis_colours[end.axis];
    if (end.positive) draw.AddLine({centre.x, centre.y}, tip, colour, 0.12f * em);
    draw.AddCircleFilled(tip, radius, end.positive ? colour : paled(colour));
    if (!end.positive) continue;
    const ImVec2 text = ImGui::CalcTextSize(axis_names[end.axis]);
    draw.AddText({tip.x - 0.5f * text.x, tip.y - 0.5f * text.y}, IM_COL32(0, 0, 0, 255),
                 axis_names[end.axis]);
  }
}

double grid_step(double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) return 0.0;
  const double wanted = radius / 5.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double times : {1.0, 2.0, 5.0})
    if (wanted <= times * power) return times * power;
  return 10.0 * power;
}

void GridOverlay::find(const Previewer& previewer) {
  const RenderScene& scene = *previewer.scene();
  const glm::dvec3 origin = scene.world().origin;
  const Box bounds = bounds_without_ground(scene.world());
  const double radius = radius_of(bounds);
  const View view = previewer.viewpoint().view();
  const Culling faces = culling_of(previewer.render().settings());
  grid_.clear();
  for (std::vector<LinePart>& axis : axes_) axis.clear();
  if (!(grid_step(radius) > 0.0)) return;
  each_grid_line(bounds, origin, radius, [&](glm::dvec3 a, glm::dvec3 b) {
    for (const LinePart& part : seen_parts(scene.rays(), view, faces, a, b))
      if (!part.hidden) grid_.push_back(part);
  });
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    glm::dvec3& tip = tips_[axis] = -origin;
    tip[static_cast<int>(axis)] += radius;
    axes_[axis] = seen_parts(scene.rays(), view, faces, -origin, tip);
  }
}

void GridOverlay::draw(const Previewer& previewer, const PictureView& view,
                       const PictureArea& area) {
  const Film& film = previewer.render().film();
  if (!previewer.scene() || film.width <= 0) return;
  const glm::ivec2 size(film.width, film.height);
  const std::uint64_t revision = previewer.viewpoint().camera().revision();
  const bool cull = previewer.render().settings().cull;
  if (scene_.lock() != previewer.scene().shared() || camera_revision_ != revision ||
      size_ != size || cull_ != cull) {
    scene_ = previewer.scene().shared();
    camera_revision_ = revision;
    size_ = size;
    cull_ = cull;
    find(previewer);
  }
  const Projection on(previewer.viewpoint(), film, view, area);
  for (const LinePart& part : grid_) two_tone_line(on, part.from, part.to);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis)
    if (!axes_[axis].empty()) draw_axis(on, axes_[axis], tips_[axis], axis);
}

}  // namespace asos::ui
