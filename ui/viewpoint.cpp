#include "ui/viewpoint.h"

#include "renderer/geometry/camera_fit.h"
#include "renderer/shading/layers.h"
#include "renderer/world/framing.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

namespace asos::ui {

namespace {

// Resizing by dragging requests many sizes; rendering waits until the size has been still for this
// time.
constexpr double size_rest_seconds = 0.15;

double subject_radius(const Box& bounds) {
  return bounds.empty() ? 1.0 : 0.5 * static_cast<double>(glm::length(bounds.hi - bounds.lo));
}

/// Distance of a camera's subject: the median depth of rays around its centre. A single ray could
/// pass through a gap and hit the horizon. 0 if nothing is hit.
double subject_distance(const RenderScene& scene, const Camera& camera) {
  constexpr int grid = 9, margin = 2;
  const View view(camera, grid, grid, radius_around_origin(scene.world().bounds));
  const glm::dvec3 eye(camera.world_from_camera[3]);
  const glm::dvec3 forward = -glm::dvec3(camera.world_from_camera[2]);
  std::vector<double> depths;
  for (int y = margin; y < grid - margin; ++y) {
    for (int x = margin; x < grid - margin; ++x) {
      const Ray ray = view.ray(x + 0.5, y + 0.5);
      const Hit hit =
          closest_visible(scene.world(), scene.render_features, scene.rays(), ray, Culling::none);
      if (hit.valid()) depths.push_back(glm::dot(glm::dvec3(ray.at(hit.t)) - eye, forward));
    }
  }
  if (depths.empty()) return 0.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

}  // namespace

Viewpoint::Viewpoint(const OpenScene& scene, RenderSettings& settings)
    : scene_(scene), settings_(settings) {}

void Viewpoint::choose_camera(int index) {
  if (!scene_) return;
  const World& world = scene_->world();
  if (index >= 0 && index < static_cast<int>(world.cameras.size())) {
    take_over(world.cameras[static_cast<std::size_t>(index)], index);
    return;
  }
  framing_ = ++framings_;
  frame(default_camera(world, aspect_ratio()));
  chosen_camera_ = -1;
  chosen_revision_ = camera_.revision();
}

void Viewpoint::follow_chosen() {
  if (!scene_ || chosen_camera_ < 0 || left_chosen()) return;
  const std::vector<Camera>& cameras = scene_->world().cameras;
  const auto index = static_cast<std::size_t>(chosen_camera_);
  if (index >= cameras.size() || cameras[index].world_from_camera == chosen_placed_) return;
  take_over(cameras[index], chosen_camera_);
}

void Viewpoint::take_over(const Camera& of_file, int index) {
  chosen_camera_ = index;
  chosen_placed_ = of_file.world_from_camera;
  const Camera camera = fitted_camera(of_file, aspect_ratio(), CameraFit::fit);
  const World& world = scene_->world();
  // Orbit the surface in view, or else a point at the scene centre's depth.
  const Box bounds = bounds_without_ground(world);
  const double radius = subject_radius(bounds);
  camera_.set(camera, radius, radius);
  double distance = subject_distance(*scene_, camera);
  if (distance <= 0.0 && !bounds.empty()) {
    const glm::dvec3 middle(0.5f * (bounds.lo + bounds.hi));
    const glm::dvec3 eye(camera.world_from_camera[3]);
    distance = glm::dot(middle - eye, -glm::dvec3(camera.world_from_camera[2]));
  }
  if (distance > 0.0) camera_.set(camera, distance, radius);
  chosen_revision_ = camera_.revision();
}

void Viewpoint::set_planes(bool on) {
  const bool left = left_chosen();
  camera_.set_planes(on);
  if (!left) chosen_revision_ = camera_.revision();
}

void Viewpoint::look_from(Side side) {
  if (!scene_) return;
  const bool framed = framing() != 0;
  turn_to(side);
  if (framed) frame_all();
}

void Viewpoint::turn_to(Side side) {
  constexpr double half_turn = std::numbers::pi, quarter = 0.5 * half_turn;
  switch (side) {
    case Side::front:
      return camera_.turn_to(0.0, 0.0);
    case Side::back:
      return camera_.turn_to(half_turn, 0.0);
    case Side::right:
      return camera_.turn_to(quarter, 0.0);
    case Side::left:
      return camera_.turn_to(-quarter, 0.0);
    case Side::top:
      return camera_.turn_to(0.0, quarter);
    case Side::bottom:
      return camera_.turn_to(0.0, -quarter);
  }
}

void Viewpoint::frame_all() {
  if (!scene_) return;
  framing_ = ++framings_;
  frame(camera_.camera());
}

void Viewpoint::frame_box(const Box& box) {
  constexpr double margin = 1.15;
  const glm::dvec3 lo(box.lo), hi(box.hi);
  const double radius = margin * 0.5 * glm::distance(lo, hi);
  const double narrow = std::min(1.0, aspect_ratio());
  camera_.look_at(0.5 * (lo + hi));
  const Camera camera = camera_.camera();
  const bool perspective = camera.type == Camera::Type::perspective;
  const double half_angle = std::atan(narrow * std::tan(0.5 * camera.fov_y_rad));
  const double wanted = perspective ? radius / std::sin(half_angle) : 2.0 * radius / narrow;
  camera_.dolly(wanted / (perspective ? camera_.distance() : camera.height));
}

void Viewpoint::make_room_to_turn() {
  if (!scene_ || framing() == 0) return;
  const Camera camera = camera_.camera();
  const double room = room_to_turn(scene_->world(), camera, camera_.pivot(), aspect_ratio());
  const bool perspective = camera.type == Camera::Type::perspective;
  const double factor = room / (perspective ? camera_.distance() : camera.height);
  if (factor > 1.0) camera_.dolly(factor);
}

void Viewpoint::frame(const Camera& camera) {
  const FramedView framed = frame_world(scene_->world(), camera, aspect_ratio());
  camera_.set(framed.camera, framed.subject_distance,
              subject_radius(bounds_without_ground(scene_->world())));
  framed_revision_ = camera_.revision();
}

void Viewpoint::frame_again() {
  const bool left = left_chosen();
  frame(camera_.camera());
  if (!left) chosen_revision_ = camera_.revision();
}

void Viewpoint::set_picture_size(int width, int height, double now_seconds) {
  if (width <= 0 || height <= 0) {
    pending_size_.reset();
    return;
  }
  if (!sized_) {
    settings_.width = width;
    settings_.height = height;
    sized_ = true;
  } else if (width == settings_.width && height == settings_.height) {
    pending_size_.reset();
  } else if (!pending_size_ || pending_size_->width != width || pending_size_->height != height) {
    pending_size_ = {width, height, now_seconds};
  }
}

void Viewpoint::settle_size(double now_seconds) {
  if (!pending_size_ || now_seconds - pending_size_->since_seconds < size_rest_seconds) return;
  settings_.width = pending_size_->width;
  settings_.height = pending_size_->height;
  pending_size_.reset();
  if (!scene_) return;
  const std::vector<Camera>& cameras = scene_->world().cameras;
  const auto chosen = static_cast<std::size_t>(chosen_camera_);
  if (framing() != 0)
    frame_again();
  else if (chosen_camera_ >= 0 && chosen < cameras.size() && !left_chosen() &&
           cameras[chosen].aspect_ratio)
    take_over(cameras[chosen], chosen_camera_);
}

std::optional<double> Viewpoint::seconds_to_settle(double now_seconds) const {
  if (!pending_size_) return std::nullopt;
  return std::max(0.0, pending_size_->since_seconds + size_rest_seconds - now_seconds);
}

View Viewpoint::view() const {
  return View(camera_.camera(), settings_.width, settings_.height,
              radius_around_origin(scene_->world().bounds));
}

Hit Viewpoint::seen_at(double x, double y) const {
  if (!scene_ || !sized_) return {};
  return closest_visible(scene_->world(), scene_->render_features, scene_->rays(), view().ray(x, y),
                         culling_of(settings_));
}

void Viewpoint::focus_at(double x, double y) {
  const Hit hit = seen_at(x, y);
  if (!hit.valid()) return;
  const View seen = view();
  Lens lens = camera_.lens().lens;
  lens.focus = seen.depth(seen.ray(x, y), hit.t);
  camera_.set_lens(lens);
}

void Viewpoint::set_pivot_at(double x, double y) {
  if (!scene_ || !sized_) return;
  const Hit hit = seen_at(x, y);
  if (hit.valid()) camera_.look_at(glm::dvec3(view().ray(x, y).at(hit.t)));
}

// Reframing for another aspect ratio is no edit, and neither is the scene's animation of the chosen
// camera.
bool Viewpoint::same_as(const State& state) const {
  return camera_.revision() == state.camera.revision() ||
         (framing() != 0 && framing() == state.framing) ||
         (chosen_camera_ >= 0 && chosen_camera_ == state.chosen_camera && !left_chosen() &&
          state.camera.revision() == state.chosen_revision);
}

void Viewpoint::restore(const State& state) {
  if (same_as(state)) return;
  camera_.restore(state.camera);
  chosen_camera_ = state.chosen_camera;
  const bool chosen = state.camera.revision() == state.chosen_revision;
  chosen_revision_ = chosen ? camera_.revision() : state.chosen_revision;
  if (state.framing == 0) return;
  framing_ = state.framing;
  framed_revision_ = camera_.revision();
  frame_again();
}

double Viewpoint::aspect_ratio() const {
  return static_cast<double>(settings_.width) / static_cast<double>(settings_.height);
}

}  // namespace asos::ui
