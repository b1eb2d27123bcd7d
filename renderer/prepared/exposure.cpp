#include "renderer/prepared/exposure.h"

#include "renderer/prepared/screen_motion.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/placements.h"
#include "renderer/world/shared_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace asos {
namespace {

using Shared = std::shared_ptr<const RenderScene>;

constexpr int first_steps = 4;
// For motion without moving vertices: lights and materials.
constexpr int least_steps = 16;

std::size_t triangles_of_meshes(const World& world) {
  std::size_t triangles = 0;
  if (!world.placements) return 0;
  for (const auto& mesh : world.placements->meshes) triangles += mesh->triangles.size();
  return triangles;
}

/// Builds moments on a grid of most_steps steps, from few to as many as are needed.
class ExposureBuilder {
 public:
  ExposureBuilder(Shared scene, const Camera& camera, const RenderSettings& settings,
                  const MomentMaker& at, bool with_edges)
      : scene_(std::move(scene)),
        camera_(camera),
        settings_(settings),
        at_(at),
        with_edges_(with_edges) {
    exposure_.shutter = settings.shutter;
    const Geometry& geometry = *scene_->geometry;
    time_ = *geometry.time;
    const auto number = static_cast<std::size_t>(time_.animation);
    if (number < geometry.contents.animations.size())
      end_ = geometry.contents.animations[number].seconds;
    exposure_.before_clip = time_.seconds - 0.5 * settings.shutter.seconds < -rounding;
    exposure_.after_clip = time_.seconds + 0.5 * settings.shutter.seconds > end_ + rounding;
    grid_[grid_.size() / 2] = scene_;
  }

  Result<Shared> run() {
    if (const auto found = find_moments(); !found) return unexpected(found.error());
    if (exposure_.limited && allowed_steps() < Exposure::most_steps) {
      if (const auto found = share_meshes(); !found) return unexpected(found.error());
    }
    for (const Shared& moment : exposure_.moments) {
      if (!with_edges_) break;
      if (const auto known = with_boundaries(moment); !known) return unexpected(known.error());
    }
    if (exposure_.moves()) exposure_.rays = std::make_shared<const MovingRays>(exposure_.moments);
    RenderScene with = *scene_;
    with.exposure = std::make_shared<const Exposure>(std::move(exposure_));
    return std::make_shared<const RenderScene>(std::move(with));
  }

 private:
  static constexpr double rounding = 1e-6;  // ends of clips are floats

  Result<void> find_moments() {
    exposure_.moments.clear();
    for (int steps = first_steps;; steps *= 2) {
      if (const auto made = make(steps); !made) return made;
      if (meshes_ && meshes_->take_dropped()) return {};
      if (steps == first_steps && !meshes_ && stands_still()) return {};
      const int wanted = wanted_steps(steps);
      exposure_.limited = wanted > steps && 2 * steps > allowed_steps();
      if (wanted > steps && !exposure_.limited) continue;
      take_moments(steps);
      return {};
    }
  }

  // Makes the moments again, with meshes that keep their shape stored once. Starts again whenever
  // one turns out to change.
  Result<void> share_meshes() {
    const auto& rig = scene_->geometry->rig;
    const Result<Scene> pose = rig ? rig->pose(time_) : Result<Scene>(Scene{});
    if (!pose) return unexpected(pose.error());
    meshes_ = std::make_shared<MeshStore>(*pose);
    do {
      // The moments so far will do if none keeps its shape.
      if (meshes_->empty()) meshes_.reset();
      grid_.fill(nullptr);
      known_.reset();
      if (!meshes_) grid_[grid_.size() / 2] = scene_;
      if (const auto found = find_moments(); !found) return found;
    } while (exposure_.moments.empty());
    return {};
  }

  Result<void> make(int steps) {
    const int stride = Exposure::most_steps / steps;
    for (int i = 0; i <= Exposure::most_steps; i += stride) {
      Shared& moment = grid_[static_cast<std::size_t>(i)];
      if (moment) continue;
      const double share = static_cast<double>(i) / Exposure::most_steps - 0.5;
      const ClipTime time{time_.animation,
                          std::clamp(time_.seconds + share * settings_.shutter.seconds, 0.0,
                                     std::max(end_, time_.seconds))};
      if (known_ && *known_->geometry->time == time) {
        moment = known_;
        continue;
      }
      // Limits the memory of concurrent searches for boundaries.
      if (known_ && with_edges_) (void)known_->geometry->boundaries.wait();
      Result<Shared> made = at_(time, meshes_);
      if (!made) return unexpected(made.error());
      moment = known_ = *std::move(made);
    }
    return {};
  }

  [[nodiscard]] const RenderScene& moment(int i, int steps) const {
    return *grid_[static_cast<std::size_t>(i * (Exposure::most_steps / steps))];
  }

  [[nodiscard]] bool stands_still() const {
    for (int i = 0; i <= first_steps; ++i) {
      const RenderScene& other = moment(i, first_steps);
      if (!same_surfaces(scene_->world(), other.world()) || scene_->lights() != other.lights())
        return false;
    }
    return true;
  }

  [[nodiscard]] ScreenWay way(int steps) const {
    std::vector<SeenMoment> seen;
    for (int i = 0; i <= steps; ++i) {
      const RenderScene& at = moment(i, steps);
      const Camera camera =
          camera_at(camera_, settings_.shutter.camera, scene_->world(), at.world());
      seen.push_back({&at, View(camera, settings_.width, settings_.height)});
    }
    return screen_way(seen);
  }

  [[nodiscard]] int wanted_steps(int steps) {
    const ScreenWay found = way(steps);
    exposure_.step_pixels = found.in_step;
    if (!found.known) return Exposure::fine_steps / 2;
    if (found.in_all == 0.0) return least_steps;
    const double way = steps * found.in_step;
    const double fine = std::max(way / Exposure::finest_step, 16.0 * std::sqrt(found.in_all));
    return static_cast<int>(std::ceil(
        std::max(std::min<double>(fine, Exposure::fine_steps),
                 std::min<double>(way / Exposure::longest_step, 2.0 * Exposure::most_steps))));
  }

  [[nodiscard]] int allowed_steps() const {
    const std::size_t most = with_edges_ ? Exposure::most_triangles : Exposure::most_ray_triangles;
    const World& world = moment(0, first_steps).world();
    const std::size_t once = meshes_ ? std::min(most, triangles_of_meshes(world)) : 0;
    const std::size_t each = std::max<std::size_t>(
        stored_triangles(world) - (meshes_ ? triangles_of_meshes(world) : 0), 1);
    return static_cast<int>(std::min<std::size_t>(Exposure::most_steps, (most - once) / each));
  }

  void take_moments(int steps) {
    for (int i = 0; i <= steps; ++i)
      exposure_.moments.push_back(
          grid_[static_cast<std::size_t>(i * (Exposure::most_steps / steps))]);
  }

  Shared scene_;
  const Camera& camera_;
  const RenderSettings& settings_;
  const MomentMaker& at_;
  const bool with_edges_;
  ClipTime time_;
  double end_ = 0.0;
  Exposure exposure_;
  std::array<Shared, Exposure::most_steps + 1> grid_;
  Shared known_;                       // the latest moment made
  std::shared_ptr<MeshStore> meshes_;  // null: each moment has its own copies
};

}  // namespace

const RayScene* MovingRays::get() const {
  std::call_once(once_, [this] {
    const std::size_t steps = moments_.size() - 1;
    const std::size_t stride = std::max<std::size_t>(1, steps / (RayScene::most_poses - 1));
    std::vector<const World*> poses;
    for (std::size_t i = 0; i <= steps; i += stride) poses.push_back(&moments_[i]->world());
    const World& first = *poses.front();
    if (!std::all_of(poses.begin(), poses.end(),
                     [&](const World* pose) { return same_but_moved(first, *pose); }))
      return;
    auto built = RayScene::build_moving(poses, alpha_at, {}, moments_.front()->forced);
    if (built) rays_ = *std::move(built);
  });
  return rays_ ? &*rays_ : nullptr;
}

std::size_t stored_triangles(const World& world) {
  constexpr std::size_t of_place = 4;  // an instance of a shared mesh takes as much memory
  const std::size_t triangles = world.triangles.own().size() + triangles_of_meshes(world);
  return world.placements ? triangles + of_place * world.placements->places.size() : triangles;
}

Result<Shared> exposed(const Shared& scene, const Camera& camera, const RenderSettings& settings,
                       const MomentMaker& at, bool with_edges) {
  if (!settings.shutter.blurs() || !scene->geometry->time) return scene;
  if (!scene->exposure) return ExposureBuilder(scene, camera, settings, at, with_edges).run();
  // The middle moment would keep the previous exposure.
  RenderScene one_moment = *scene;
  one_moment.exposure.reset();
  return ExposureBuilder(std::make_shared<const RenderScene>(std::move(one_moment)), camera,
                         settings, at, with_edges)
      .run();
}

Camera camera_at(const Camera& camera, int followed, const World& now, const World& then) {
  const auto number = static_cast<std::size_t>(followed);
  if (followed < 0 || number >= now.cameras.size() || number >= then.cameras.size()) return camera;
  const Camera &from = now.cameras[number], &to = then.cameras[number];
  if (from == to) return camera;
  Camera moved = camera;
  moved.world_from_camera =
      to.world_from_camera * glm::inverse(from.world_from_camera) * camera.world_from_camera;
  if (camera.type != from.type || camera.type != to.type) return moved;
  const double wider = std::tan(0.5 * to.fov_y_rad) / std::tan(0.5 * from.fov_y_rad);
  if (camera.type == Camera::Type::perspective && wider != 1.0)
    moved.fov_y_rad = 2.0 * std::atan(std::tan(0.5 * camera.fov_y_rad) * wider);
  if (camera.type == Camera::Type::orthographic) moved.height *= to.height / from.height;
  return moved;
}

std::vector<std::string> exposure_remarks(const Exposure& exposure) {
  std::vector<std::string> remarks;
  if (!exposure.moves())
    remarks.emplace_back("nothing moves while the shutter is open; the picture has no motion blur");
  if (exposure.before_clip)
    remarks.emplace_back(
        "the shutter opens before the animation begins; its first pose is shown until then");
  if (exposure.after_clip)
    remarks.emplace_back(
        "the shutter closes after the animation's end; its last pose is shown from there");
  if (exposure.limited)
    remarks.push_back(
        fmt::format("motion blur is limited to {} steps; in one of them a vertex moves by up to "
                    "{:.2g} pixels",
                    exposure.steps(), exposure.step_pixels));
  return remarks;
}

}  // namespace asos
