#include "renderer/shading/environment_picture.h"

#include "renderer/shading/sky.h"
#include "renderer/tasks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tbb/task_arena.h>
#include <utility>
#include <vector>

namespace asos {
namespace {

constexpr int picture_width = 1024;
/// Width of the picture for the lobes, whose panels have edges as soft as its texels.
constexpr int lobes_width = 256;
/// Width of a panel's edge, some two texels.
constexpr double panel_edge = 0.012;

/// A rectangle around the scene that faces its centre. Azimuths are about +Y from +Z.
struct Panel {
  double azimuth_deg, elevation_deg;
  double half_width, half_height;  ///< at a distance of 1
  glm::dvec3 radiance;
  int columns = 1, rows = 1;  ///< panes between bars
};

/// A room: walls and floor, linear in the height of a direction, with its panels.
struct Room {
  glm::dvec3 nadir, floor, wall, zenith;
  std::span<const Panel> panels;
};

// The default lights are visible in mirrors by themselves; these panels are additional.
constexpr Panel soft_boxes[] = {
    {0.0, 90.0, 0.55, 0.42, glm::dvec3(1.4)},   {-78.0, 24.0, 0.30, 0.44, glm::dvec3(1.8)},
    {60.0, 20.0, 0.10, 0.55, glm::dvec3(1.8)},  {84.0, 20.0, 0.10, 0.55, glm::dvec3(1.8)},
    {165.0, 30.0, 0.45, 0.14, glm::dvec3(1.4)}, {-30.0, 8.0, 0.20, 0.42, glm::dvec3(0.06)},
    {112.0, 8.0, 0.18, 0.60, glm::dvec3(0.06)}, {-135.0, 8.0, 0.24, 0.60, glm::dvec3(0.06)},
};
constexpr Panel room_windows[] = {
    {-78.0, 18.0, 0.30, 0.42, {2.3, 2.6, 3.0}, 2, 3},
    {-40.0, 18.0, 0.26, 0.42, {2.3, 2.6, 3.0}, 2, 3},
    {-4.0, 18.0, 0.30, 0.42, {2.3, 2.6, 3.0}, 2, 3},
    {88.0, 14.0, 0.32, 0.36, {1.3, 1.5, 1.8}, 3, 2},
    {150.0, 6.0, 0.22, 0.50, {0.10, 0.08, 0.06}},
    {-168.0, 16.0, 0.30, 0.16, {1.6, 1.15, 0.75}},
};

constexpr Room soft_box_room{glm::dvec3(0.24), glm::dvec3(0.33), glm::dvec3(0.46), glm::dvec3(0.70),
                             soft_boxes};
constexpr Room window_room{
    {0.10, 0.075, 0.05}, {0.26, 0.20, 0.145}, {0.46, 0.44, 0.40}, {0.62, 0.62, 0.62}, room_windows};

/// Returns 1 within `half` and 0 beyond.
double within(double distance, double half, double edge) {
  return std::clamp(0.5 + (half - distance) / edge, 0.0, 1.0);
}

/// A panel with its own axes.
struct PlacedPanel {
  const Panel* panel;
  double edge;
  glm::dvec3 forward, right, up;
  double least_ahead;  ///< of the directions to its corners

  PlacedPanel(const Panel& of, double with_edge) : panel(&of), edge(with_edge) {
    constexpr double degree = std::numbers::pi / 180.0;
    const double a = of.azimuth_deg * degree, e = of.elevation_deg * degree;
    forward = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    right = {std::cos(a), 0.0, -std::sin(a)};
    up = glm::cross(forward, right);
    const double width = of.half_width + edge, height = of.half_height + edge;
    least_ahead = std::max(0.05, 1.0 / std::sqrt(1.0 + width * width + height * height));
  }

  /// Returns the panel's coverage of a direction, 0 to 1.
  [[nodiscard]] double cover(glm::dvec3 d) const {
    const double ahead = glm::dot(forward, d);
    if (ahead < least_ahead) return 0.0;
    const double x = glm::dot(right, d) / ahead, y = glm::dot(up, d) / ahead;
    const double covered = within(std::abs(x), panel->half_width, edge) *
                           within(std::abs(y), panel->half_height, edge);
    if (covered == 0.0) return 0.0;
    return covered * beside_bars(x, panel->half_width, panel->columns) *
           beside_bars(y, panel->half_height, panel->rows);
  }

 private:
  [[nodiscard]] double beside_bars(double at, double half, int panes) const {
    constexpr double bar = 0.012;
    double free = 1.0;
    for (int i = 1; i < panes; ++i)
      free *= 1.0 - within(std::abs(at - half * (2.0 * i / panes - 1.0)), bar, edge);
    return free;
  }
};

class PlacedRoom {
 public:
  explicit PlacedRoom(const Room& room, double edge = panel_edge) : room_(room), edge_(edge) {
    for (const Panel& panel : room.panels) panels_.emplace_back(panel, edge);
  }

  [[nodiscard]] glm::dvec3 radiance(glm::dvec3 d) const {
    const glm::dvec3 above = glm::mix(room_.wall, room_.zenith, std::max(0.0, d.y));
    const glm::dvec3 below = glm::mix(room_.floor, room_.nadir, std::max(0.0, -d.y));
    glm::dvec3 radiance = glm::mix(below, above, within(-d.y, 0.0, edge_));
    for (const PlacedPanel& placed : panels_)
      radiance = glm::mix(radiance, placed.panel->radiance, placed.cover(d));
    return radiance;
  }

 private:
  Room room_;
  double edge_;
  std::vector<PlacedPanel> panels_;
};

SkyMap painted(const PlacedRoom& room, int width) {
  const int height = width / 2;
  std::vector<glm::dvec2> turns;  // sine and cosine
  for (int x = 0; x < width; ++x) {
    // As in SkyRows, column 0 is at +Z and columns continue through -X.
    const double turn = 2.0 * std::numbers::pi * (x + 0.5) / width;
    turns.emplace_back(std::sin(turn), std::cos(turn));
  }
  std::vector<glm::vec3> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto paint_row = [&](std::size_t y) {
    const double fall = std::numbers::pi * (static_cast<double>(y) + 0.5) / height;
    const double sine = std::sin(fall), cosine = std::cos(fall);
    glm::vec3* row = &texels[y * static_cast<std::size_t>(width)];
    for (const glm::dvec2 turn : turns)
      *row++ = room.radiance({-turn.x * sine, cosine, turn.y * sine});
  };
  // A thread that waits here must not begin another task: that may wait for this picture.
  tbb::this_task_arena::isolate([&] { in_tasks(static_cast<std::size_t>(height), paint_row); });
  return {width, height, std::move(texels)};
}

const Room* room_of(Environment environment) {
  if (environment == Environment::softboxes) return &soft_box_room;
  if (environment == Environment::windows) return &window_room;
  return nullptr;
}

std::shared_ptr<const SkyLobes> lobes_of(const Room& room) {
  const PlacedRoom soft(room, 2.0 * std::numbers::pi / lobes_width);
  return std::make_shared<const SkyLobes>(painted(soft, lobes_width));
}

}  // namespace

bool has_picture(Environment environment) {
  return room_of(environment) != nullptr;
}

const SkyMap& environment_picture(Environment environment) {
  if (environment == Environment::softboxes) {
    static const SkyMap picture = painted(PlacedRoom(soft_box_room), picture_width);
    return picture;
  }
  static const SkyMap picture = painted(PlacedRoom(window_room), picture_width);
  return picture;
}

std::shared_ptr<const SkyLobes> environment_lobes(Environment environment) {
  if (environment == Environment::softboxes) {
    static const std::shared_ptr<const SkyLobes> lobes = lobes_of(soft_box_room);
    return lobes;
  }
  if (environment == Environment::windows) {
    static const std::shared_ptr<const SkyLobes> lobes = lobes_of(window_room);
    return lobes;
  }
  return nullptr;
}

glm::vec3 environment_radiance(Environment environment, glm::dvec3 direction) {
  if (const Room* room = room_of(environment)) return PlacedRoom(*room).radiance(direction);
  return Sky(environment).radiance(direction);
}

}  // namespace asos
