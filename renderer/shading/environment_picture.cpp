#include "renderer/shading/environment_picture.h"

#include "renderer/shading/sky.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

constexpr int picture_width = 1024;

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

/// Returns 1 within `half` and 0 beyond, with an edge about two texels wide.
double within(double distance, double half) {
  constexpr double edge = 0.012;
  return std::clamp(0.5 + (half - distance) / edge, 0.0, 1.0);
}

/// A panel with its own axes.
struct PlacedPanel {
  const Panel* panel;
  glm::dvec3 forward, right, up;

  explicit PlacedPanel(const Panel& of) : panel(&of) {
    constexpr double degree = std::numbers::pi / 180.0;
    const double a = of.azimuth_deg * degree, e = of.elevation_deg * degree;
    forward = {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    right = {std::cos(a), 0.0, -std::sin(a)};
    up = glm::cross(forward, right);
  }

  /// Returns the panel's coverage of a direction, 0 to 1.
  [[nodiscard]] double cover(glm::dvec3 d) const {
    const double ahead = glm::dot(forward, d);
    if (ahead < 0.05) return 0.0;
    const double x = glm::dot(right, d) / ahead, y = glm::dot(up, d) / ahead;
    const double covered =
        within(std::abs(x), panel->half_width) * within(std::abs(y), panel->half_height);
    if (covered == 0.0) return 0.0;
    return covered * beside_bars(x, panel->half_width, panel->columns) *
           beside_bars(y, panel->half_height, panel->rows);
  }

 private:
  static double beside_bars(double at, double half, int panes) {
    constexpr double bar = 0.012;
    double free = 1.0;
    for (int i = 1; i < panes; ++i)
      free *= 1.0 - within(std::abs(at - half * (2.0 * i / panes - 1.0)), bar);
    return free;
  }
};

class PlacedRoom {
 public:
  explicit PlacedRoom(const Room& room)
      : room_(room), panels_(room.panels.begin(), room.panels.end()) {}

  [[nodiscard]] glm::dvec3 radiance(glm::dvec3 d) const {
    const glm::dvec3 above = glm::mix(room_.wall, room_.zenith, std::max(0.0, d.y));
    const glm::dvec3 below = glm::mix(room_.floor, room_.nadir, std::max(0.0, -d.y));
    glm::dvec3 radiance = glm::mix(below, above, within(-d.y, 0.0));
    for (const PlacedPanel& placed : panels_)
      radiance = glm::mix(radiance, placed.panel->radiance, placed.cover(d));
    return radiance;
  }

 private:
  Room room_;
  std::vector<PlacedPanel> panels_;
};

std::shared_ptr<const SkyMap> painted(const Room& of) {
  const PlacedRoom room(of);
  constexpr int height = picture_width / 2;
  std::vector<glm::vec3> texels;
  texels.reserve(static_cast<std::size_t>(picture_width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < picture_width; ++x) {
      // As in SkyRows, column 0 is at +Z and columns continue through -X.
      const double turn = 2.0 * std::numbers::pi * (x + 0.5) / picture_width;
      const double fall = std::numbers::pi * (y + 0.5) / height;
      const glm::dvec3 d(-std::sin(turn) * std::sin(fall), std::cos(fall),
                         std::cos(turn) * std::sin(fall));
      texels.emplace_back(room.radiance(d));
    }
  }
  return std::make_shared<const SkyMap>(picture_width, height, std::move(texels));
}

const Room* room_of(Environment environment) {
  if (environment == Environment::softboxes) return &soft_box_room;
  if (environment == Environment::windows) return &window_room;
  return nullptr;
}

}  // namespace

std::shared_ptr<const SkyMap> environment_picture(Environment environment) {
  if (environment == Environment::softboxes) {
    static const std::shared_ptr<const SkyMap> picture = painted(soft_box_room);
    return picture;
  }
  if (environment == Environment::windows) {
    static const std::shared_ptr<const SkyMap> picture = painted(window_room);
    return picture;
  }
  return nullptr;
}

glm::vec3 environment_radiance(Environment environment, glm::dvec3 direction) {
  if (const Room* room = room_of(environment)) return PlacedRoom(*room).radiance(direction);
  return Sky(environment).radiance(direction);
}

}  // namespace asos
