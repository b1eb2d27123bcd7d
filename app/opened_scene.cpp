#include "app/opened_scene.h"

#include "app/scene_argument.h"
#include "app/shutter_option.h"
#include "renderer/prepared/default_look.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/framing.h"

#include <utility>

namespace asos {
namespace {

/// The time of the picture given by --from, if it shows the same scene.
std::optional<ClipTime> time_of_from(const PictureArguments& wanted) {
  const bool same = wanted.from && wanted.from->scene == wanted.scene;
  return same ? wanted.from->time : std::nullopt;
}

}  // namespace

Result<OpenedScene> OpenedScene::open(const PictureArguments& wanted) {
  const std::optional<ClipTime> as_before = time_of_from(wanted);
  const ShutterSettings& shutter = wanted.settings.shutter;
  const bool moves = wanted.clip.any() || as_before || shutter.blurs();
  LoadOptions options = load_options_of(wanted);
  options.keep_posable = moves;
  Result<Scene> scene = open_scene_argument(wanted.scene, options);
  if (!scene) return tl::unexpected(scene.error());
  OpenedScene opened;
  opened.wanted_ = wanted;
  opened.at_rest_ = *std::move(scene);
  opened.contents_ = opened.at_rest_.contents;
  opened.cameras_ = opened.at_rest_.cameras.size();
  if (const auto fits = check_shutter(shutter, opened.contents_, wanted.scene); !fits)
    return tl::unexpected(fits.error());
  if (!moves) return opened;

  opened.time_ = as_before.value_or(ClipTime{});
  if (wanted.clip.animation || !as_before) {
    const Result<int> animation =
        find_animation(opened.contents_, wanted.scene, wanted.clip.animation);
    if (!animation) return tl::unexpected(animation.error());
    opened.time_->animation = *animation;
  }
  if (wanted.clip.seconds) opened.time_->seconds = *wanted.clip.seconds;
  if (!opened.at_rest_.rig)
    return tl::unexpected(Error{wanted.scene, "has no animations, so there is no such time of it"});
  if (const auto staged = opened.go_on_stage(wanted); !staged)
    return tl::unexpected(staged.error());
  const CameraChoice& camera = wanted.camera;
  if (!camera.index && !camera.look_at && !as_before && opened.stage_->world().cameras.empty())
    opened.frame_animation();
  return opened;
}

Result<void> OpenedScene::go_on_stage(const PictureArguments& wanted) {
  auto prepared = prepare(at_rest_, forced_by(wanted.render_features));
  if (!prepared) return tl::unexpected(prepared.error());
  stage_ = *std::move(prepared);
  at_rest_ = Scene{};
  return {};
}

void OpenedScene::frame_animation() {
  constexpr int moments = 8;
  const auto& clip = contents_.animations[static_cast<std::size_t>(time_->animation)];
  const Geometry& at_rest = *stage_->geometry;
  for (int i = 0; i <= moments; ++i) {
    const Result<Scene> posed =
        at_rest.rig->pose(ClipTime{time_->animation, clip.seconds * i / moments});
    if (!posed) continue;  // nothing can be drawn at this time
    Result<FlattenedScene> flat =
        flatten(*posed, most_triangles, at_rest.stage.origin, never_shared);
    if (!flat || flat->world.bounds.empty()) continue;
    if (framed_)
      frame_also(*framed_, flat->world);
    else
      framed_ = std::move(flat->world);
  }
}

Result<std::shared_ptr<const RenderScene>> OpenedScene::at(const std::optional<ClipTime>& time,
                                                           const PictureDescription& picture) {
  if (newest_ && newest_->geometry->time == time) return newest_;
  newest_.reset();
  const ChooseGround choose = [this](const World& world, bool dark) {
    return GroundChoice{ground_of_picture(world, dark)};
  };
  if (stage_) {
    auto prepared = posed(time, picture, choose);
    if (!prepared) return prepared;
    return newest_ = *std::move(prepared);
  }
  auto prepared = prepare_posed(at_rest_, picture, nullptr, choose);
  if (!prepared) return prepared;
  // The unprepared scene is no longer needed.
  at_rest_ = Scene{};
  return newest_ = *std::move(prepared);
}

Result<std::shared_ptr<const RenderScene>> OpenedScene::posed(
    const std::optional<ClipTime>& time, const PictureDescription& picture,
    const ChooseGround& choose, const std::shared_ptr<MeshStore>& meshes) const {
  const Result<Scene> posed = stage_->geometry->rig->pose(time);
  if (!posed) return tl::unexpected(posed.error());
  AnimationInvariants stage = stage_->geometry->stage;
  stage.meshes = meshes;
  return prepare_posed(*posed, picture, &stage, choose);
}

// The automatic exposure of a picture is metered without a ground.
Ground OpenedScene::ground_of_picture(const World& world, bool dark) const {
  if (!expects_ground_ || wanted_.exposure_metered || (!wanted_.exposure_chosen && !dark))
    return Ground::off;
  if (wanted_.sky_chosen || wanted_.ground_chosen) return wanted_.settings.ground;
  CameraChoice choice = wanted_.camera;
  if (wanted_.from) choice.given = wanted_.from->camera_from(world.origin);
  const double aspect = static_cast<double>(wanted_.settings.width) / wanted_.settings.height;
  const Result<Camera> chosen = camera(world, choice, aspect);
  return chosen ? likely_ground(world, dark, *chosen) : Ground::off;
}

Result<std::shared_ptr<const RenderScene>> OpenedScene::at_rest(const PictureDescription& picture) {
  if (stage_) return stage_;
  return at(std::nullopt, picture);
}

Result<Camera> OpenedScene::camera(const World& world, const CameraChoice& choice,
                                   double aspect_ratio) const {
  const bool framed = !choice.index && !choice.look_at && !choice.given && world.cameras.empty();
  return choose_camera(framed_ && framed ? *framed_ : world, choice, aspect_ratio);
}

}  // namespace asos
