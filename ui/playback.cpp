#include "ui/playback.h"

#include "renderer/comparison/method.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

double elapsed_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Applies the edited lights and materials to another pose of the scene. `as`: see with_ground.
Result<std::shared_ptr<const RenderScene>> with_look(
    std::shared_ptr<const RenderScene> scene, const std::optional<std::vector<Light>>& lights,
    const std::optional<MaterialDfrs>& dfrs, Ground ground, const World* as) {
  Result<std::shared_ptr<const RenderScene>> edited = std::move(scene);
  if (lights) edited = with_lights(*edited, *lights);
  if (edited && dfrs) edited = with_dfrs(*edited, *dfrs);
  if (edited) edited = with_ground(*edited, ground, as);
  return edited;
}

/// The edits of a pose, and the meshes that it shares with others.
struct PoseEdits {
  const std::optional<std::vector<Light>>& lights;
  const std::optional<MaterialDfrs>& dfrs;
  Ground ground;
  const World* as = nullptr;  ///< see with_ground
  std::shared_ptr<MeshStore> meshes{};
};

/// Prepares a pose of the scene on its ground, with the edits.
Result<std::shared_ptr<const RenderScene>> prepared_pose(const Scene& pose, const RenderScene& from,
                                                         const PoseEdits& edits) {
  AnimationInvariants stage = from.geometry->stage;
  stage.meshes = edits.meshes;
  const auto choose = [&](const World&, bool) { return GroundChoice{edits.ground, edits.as}; };
  return prepare_on_ground(pose, from.forced, &stage, choose).and_then([&](auto prepared) {
    return with_look(std::move(prepared), edits.lights, edits.dfrs, edits.ground, edits.as);
  });
}

/// Draws lines and points for this pose as the camera sees them.
Result<std::shared_ptr<const RenderScene>> drawn(std::shared_ptr<const RenderScene> scene,
                                                 const Playback::LineRequest& lines_and_points) {
  LinePicture picture = lines_and_points.picture;
  const std::vector<Camera>& cameras = scene->world().cameras;
  const auto followed = static_cast<std::size_t>(lines_and_points.follows);
  if (lines_and_points.follows >= 0 && followed < cameras.size())
    picture.camera = cameras[followed];
  return with_lines(std::move(scene), picture);
}

}  // namespace

Playback::Playback(OpenScene& scene, SceneEdits& edits, std::function<void()> wake)
    : scene_(scene), edits_(edits), job_(posed, std::move(wake), Overtaken::dropped) {}

const std::vector<SceneContents::Animation>& Playback::animations() const {
  static const std::vector<SceneContents::Animation> none;
  return available() ? scene_->geometry->contents.animations : none;
}

double Playback::duration_seconds() const {
  if (!time_ || !available()) return 0.0;
  return animations()[static_cast<std::size_t>(time_->animation)].seconds;
}

void Playback::choose(int animation) {
  if (animation >= static_cast<int>(animations().size())) return;
  has_failed_ = false;
  if (animation < 0) {
    time_.reset();
    playing_ = false;
  } else {
    time_ = ClipTime{animation, 0.0};
  }
}

void Playback::seek(double seconds) {
  if (!available() || !std::isfinite(seconds)) return;
  if (!time_) choose(0);
  has_failed_ = false;
  time_->seconds = std::clamp(seconds, 0.0, duration_seconds());
}

void Playback::step(int frames) {
  set_playing(false);
  const double now = time_ ? time_->seconds : 0.0;
  // From between two frames, a step goes to the next frame, not past it.
  const double at = now * options_.fps, whole = std::round(at);
  const double from = std::abs(at - whole) < 1e-6 ? whole
                      : frames > 0                ? std::floor(at)
                                                  : std::ceil(at);
  seek((from + frames) / options_.fps);
}

void Playback::set_playing(bool playing) {
  if (!available()) return;
  playing_ = playing;
  if (!playing) return;
  const bool at_end = time_ && !options_.loop && time_->seconds >= duration_seconds();
  if (!time_ || at_end) seek(0.0);
}

void Playback::adopt_scene(bool again) {
  const std::size_t count = animations().size();
  const bool keeps = again && time_ && static_cast<std::size_t>(time_->animation) < count;
  if (!keeps) time_ = scene_->geometry->time;
  playing_ = playing_ && keeps;
  has_failed_ = false;
  if (keeps) seek(time_->seconds);
  // Each pose builds the hierarchies of the parts that move.
  const bool fast = available() && scene_->geometry->build_seconds * least_poses < 1.0;
  if (options_.plays_at_first && !again && !time_ && count == 1 && fast) set_playing(true);
}

void Playback::update(bool seen, double now_seconds,
                      const std::optional<LineRequest>& lines_and_points,
                      const std::optional<WantedExposure>& exposure) {
  exposure_ = exposure;
  const double passed = updated_seconds_ ? now_seconds - *updated_seconds_ : 0.0;
  updated_seconds_ = now_seconds;
  if (!available()) return;
  take_pose();
  if (playing_) let_time_pass(std::max(0.0, passed));
  if (posing() && !job_.pending() && (seen || !playing_)) ask(lines_and_points);
}

void Playback::let_time_pass(double seconds) {
  const double end = duration_seconds();
  double at = time_->seconds + seconds * std::clamp(options_.speed, slowest, fastest);
  if (at >= end && !options_.loop) playing_ = false;
  if (at >= end) at = options_.loop && end > 0.0 ? std::fmod(at, end) : end;
  time_->seconds = at;
}

bool Playback::posing() const {
  if (!available() || (at_wanted_time() && !exposes())) return false;
  return !(has_failed_ && failed_ == time_);
}

// Whether the present pose is to be exposed, or exposed anew.
bool Playback::exposes() const {
  if (playing_ || !time_ || !exposure_ || !exposure_->settings.shutter.blurs()) return false;
  const Exposure* now = scene_->exposure.get();
  return !now || now->shutter.seconds != exposure_->settings.shutter.seconds;
}

void Playback::ask(const std::optional<LineRequest>& lines_and_points) {
  Request request{scene_.shared(),
                  time_,
                  std::nullopt,
                  std::nullopt,
                  edits_.revisions(),
                  scene_.times_opened(),
                  edits_.settings().ground,
                  lines_and_points,
                  at_wanted_time() ? exposure_ : std::nullopt};
  request.lights = edited_lights();
  request.dfrs = edited_dfrs();
  job_.ask(std::move(request));
}

std::optional<std::vector<Light>> Playback::edited_lights() const {
  if (scene_->lighting == scene_->own_lighting) return std::nullopt;
  return lights_on(edits_.lights());
}

std::optional<MaterialDfrs> Playback::edited_dfrs() const {
  if (edits_.dfrs() == dfrs_without_ground(scene_->world())) return std::nullopt;
  return edits_.dfrs();
}

Result<std::shared_ptr<const RenderScene>> Playback::scene_at(
    const RenderScene& from, const std::optional<ClipTime>& time,
    const std::optional<std::vector<Light>>& lights, const std::optional<MaterialDfrs>& dfrs,
    Ground ground, const World* as, const std::shared_ptr<MeshStore>& meshes) {
  const Result<Scene> scene = from.geometry->rig->pose(time);
  if (!scene) return unexpected(scene.error());
  return prepared_pose(*scene, from, {lights, dfrs, ground, as, meshes});
}

Result<std::shared_ptr<const RenderScene>> Playback::exposed_scene(
    const std::shared_ptr<const RenderScene>& scene, const WantedExposure& wanted,
    const std::optional<std::vector<Light>>& lights, const std::optional<MaterialDfrs>& dfrs) {
  const RenderSettings& settings = wanted.settings;
  const auto at = [&](const ClipTime& time, const std::shared_ptr<MeshStore>& meshes) {
    auto moment = scene_at(*scene, time, lights, dfrs, settings.ground, &scene->world(), meshes);
    if (!moment || (*moment)->world().lines_and_points.empty()) return moment;
    const Camera then =
        camera_at(wanted.camera, settings.shutter.camera, scene->world(), (*moment)->world());
    return with_lines(*moment, line_picture(then, settings));
  };
  return exposed(scene, wanted.camera, settings, at, needs_boundaries(settings.method));
}

Playback::Pose Playback::posed(const Request& request) {
  Pose pose{request.from, request.time, request.look, request.opened, 0.0, 0.0, {}};
  const Geometry& geometry = *request.from->geometry;
  const auto start = std::chrono::steady_clock::now();
  try {
    if (request.exposure) {
      pose.scene = exposed_scene(request.from, *request.exposure, request.lights, request.dfrs);
      pose.lines_and_points = request.lines_and_points;
      pose.exposed = true;
      return pose;
    }
    Result<Scene> scene = geometry.rig->pose(request.time);
    pose.pose_seconds = elapsed_since(start);
    if (!scene) {
      pose.scene = unexpected(scene.error());
      return pose;
    }
    pose.scene =
        prepared_pose(*scene, *request.from, {request.lights, request.dfrs, request.ground});
    if (pose.scene && request.lines_and_points &&
        !(*pose.scene)->world().lines_and_points.empty()) {
      pose.lines_and_points = request.lines_and_points;
      pose.scene = drawn(*std::move(pose.scene), *request.lines_and_points);
    }
  } catch (const std::bad_alloc&) {
    pose.scene = unexpected(Error{geometry.source, "not enough memory for another frame"});
  }
  pose.prepare_seconds = elapsed_since(start) - pose.pose_seconds;
  return pose;
}

void Playback::take_pose() {
  std::optional<Pose> pose = job_.take_outcome();
  // Another scene may have been opened meanwhile.
  if (!pose || pose->opened != scene_.times_opened()) return;
  if (!pose->scene) {
    scene_.report(pose->scene.error());
    failed_ = pose->time;
    has_failed_ = true;
    playing_ = false;
    return;
  }
  scene_.relight(std::move(*pose->scene));
  edits_.scene_has(pose->look);
  drawn_lines_ = pose->lines_and_points;
  if (pose->exposed) return;
  pose_seconds_ = pose->pose_seconds;
  prepare_seconds_ = pose->prepare_seconds;
}

}  // namespace asos::ui
