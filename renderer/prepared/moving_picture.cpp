#include "renderer/prepared/moving_picture.h"

#include "renderer/prepared/screen_motion.h"
#include "renderer/world/placements.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
namespace {

// Tiles of large pictures are larger, which bounds their memory.
constexpr int least_tile = 8, most_tiles = 1024;

int tile_scale(int side) {
  return (side + least_tile * most_tiles - 1) / (least_tile * most_tiles);
}

bool same_view(const Camera& a, const Camera& b) {
  return a.world_from_camera == b.world_from_camera && a.fov_y_rad == b.fov_y_rad &&
         a.height == b.height;
}

}  // namespace

MovingPicture::MovingPicture(const RenderScene& scene, const Camera& camera,
                             const RenderSettings& settings)
    : exposure_(scene.exposure.get()),
      margin_(0.5 * settings.filter_width + 1.0),
      tile_(least_tile * tile_scale(std::max(settings.width, settings.height))),
      columns_((settings.width + tile_ - 1) / tile_),
      rows_((settings.height + tile_ - 1) / tile_),
      crossed_(static_cast<std::size_t>(exposure_->steps()) * static_cast<std::size_t>(columns_) *
                   static_cast<std::size_t>(rows_),
               0) {
  std::vector<Camera> cameras;
  for (const auto& moment : exposure_->moments) {
    cameras.push_back(camera_at(camera, settings.shutter.camera, scene.world(), moment->world()));
    views_.emplace_back(cameras.back(), settings.width, settings.height,
                        radius_around_origin(moment->world().bounds));
  }
  for (int i = 0; i < steps(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    camera_moves_ |= !same_view(cameras[k], cameras[k + 1]);
    if (!same_view(cameras[k], cameras[k + 1]) || camera.lens.blurs())
      mark_all(i);
    else
      mark(i, this->scene(i), this->scene(i + 1));
  }
}

int MovingPicture::moment_at(double time) const {
  return std::clamp(static_cast<int>(std::lround(time * steps())), 0, steps());
}

bool MovingPicture::crosses(const PixelRect& block, int first, int last) const {
  const int x0 = block.x / tile_, x1 = (block.x + block.width - 1) / tile_;
  const int y0 = block.y / tile_, y1 = (block.y + block.height - 1) / tile_;
  for (int step = first; step < last; ++step)
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        if (crossed_[static_cast<std::size_t>((step * rows_ + y) * columns_ + x)]) return true;
  return false;
}

void MovingPicture::mark_all(int step) {
  const auto size = static_cast<std::ptrdiff_t>(columns_) * rows_;
  std::fill_n(crossed_.begin() + step * size, size, std::uint8_t{1});
}

void MovingPicture::mark_box(int step, glm::dvec2 lo, glm::dvec2 hi) {
  const auto tile_of = [&](double at, int count) {
    return static_cast<int>(std::floor(std::clamp(at / tile_, -1.0, static_cast<double>(count))));
  };
  const int x0 = std::max(tile_of(lo.x - margin_, columns_), 0);
  const int y0 = std::max(tile_of(lo.y - margin_, rows_), 0);
  const int x1 = std::min(tile_of(hi.x + margin_, columns_), columns_ - 1);
  const int y1 = std::min(tile_of(hi.y + margin_, rows_), rows_ - 1);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      crossed_[static_cast<std::size_t>((step * rows_ + y) * columns_ + x)] = 1;
}

void MovingPicture::mark(int step, const RenderScene& before, const RenderScene& after) {
  const World &a = before.world(), &b = after.world();
  const auto from = screen_points(a, view(step)), to = screen_points(b, view(step + 1));
  if (from.size() != to.size() || !same_but_moved(a, b)) return mark_all(step);
  // Marks the box around points at both moments.
  bool behind = false;
  const auto mark_points = [&](auto&& points) {
    glm::dvec2 lo(1e30), hi(-1e30);
    for (const std::size_t i : points) {
      for (const auto* at : {&from[i], &to[i]}) {
        behind |= !*at;
        if (!*at) return;
        lo = glm::min(lo, **at);
        hi = glm::max(hi, **at);
      }
    }
    mark_box(step, lo, hi);
  };
  const auto of_triangle = [&](glm::uvec3 t) {
    mark_points(std::array<std::size_t, 3>{t.x, t.y, t.z});
  };
  for (std::size_t i = 0; i < a.triangles.own().size() && !behind; ++i) {
    const glm::uvec3 t = a.triangles.own()[i];
    if (a.positions[t.x] != b.positions[t.x] || a.positions[t.y] != b.positions[t.y] ||
        a.positions[t.z] != b.positions[t.z])
      of_triangle(t);
  }
  for (std::size_t i = 0; a.placements && i < a.placements->places.size() && !behind; ++i) {
    const Placement& place = a.placements->places[i];
    if (place.world_from_mesh == b.placements->places[i].world_from_mesh) continue;
    const std::uint32_t first = a.placements->own_vertices + place.first_vertex;
    for (const glm::uvec3 t : a.placements->mesh_of(place).triangles.own())
      if (!behind) of_triangle(t + first);
  }
  std::vector<bool> moves(a.parts.size(), a.faces.size() != b.faces.size());
  for (std::size_t i = 0; i < a.faces.size() && i < b.faces.size(); ++i)
    if (!(a.faces[i] == b.faces[i])) moves[a.faces[i].part] = true;
  std::size_t corner = a.positions.size();
  for (std::size_t i = 0; i < a.parts.size() && !behind; ++i) {
    if (a.parts[i].face_count == 0) continue;
    if (moves[i])
      mark_points(std::array<std::size_t, 8>{corner, corner + 1, corner + 2, corner + 3, corner + 4,
                                             corner + 5, corner + 6, corner + 7});
    corner += 8;
  }
  if (behind) mark_all(step);
}

}  // namespace asos
