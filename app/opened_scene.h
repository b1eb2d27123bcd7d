#pragma once

#include "app/picture_options.h"
#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// The scene of a command line, read once, to be rendered at one or several times of its animation.
class OpenedScene {
 public:
  /// Reads the scene. If the command line selects a time, the scene at rest is prepared, too: it
  /// defines the default camera and the default lighting.
  [[nodiscard]] static Result<OpenedScene> open(const PictureArguments& wanted);

  /// The selected time, or that of the picture given by --from; none: the scene at rest.
  [[nodiscard]] const std::optional<ClipTime>& time() const { return time_; }
  [[nodiscard]] const SceneContents& contents() const { return contents_; }
  /// Number of cameras that the file places.
  [[nodiscard]] std::size_t cameras() const { return cameras_; }

  /// Makes `at` build scenes on the ground that their pictures will probably have (default_look),
  /// so that with_ground need not build them again.
  void expect_ground() { expects_ground_ = true; }
  /// Returns the scene prepared for that time, lit as `picture` says, and keeps the last one.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> at(const std::optional<ClipTime>& time,
                                                              const PictureDescription& picture);
  /// The same at a time of a scene that moves; the result is not kept. `choose`: the ground to
  /// build it with. `meshes`: AnimationInvariants::meshes.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> posed(
      const std::optional<ClipTime>& time, const PictureDescription& picture,
      const ChooseGround& choose, const std::shared_ptr<MeshStore>& meshes = nullptr) const;
  /// The scene as the file's nodes place it, if it moves; otherwise the result of `at`.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> at_rest(
      const PictureDescription& picture);
  /// Replaces the last scene by this one with its lights and ground; `at` of the same time returns
  /// it. Frees the hierarchies of the one before.
  void keep(std::shared_ptr<const RenderScene> scene) { newest_ = std::move(scene); }
  /// Returns the camera for a picture of `world`, which is that of one of the scenes above. Without
  /// cameras in the file, it frames the whole animation.
  [[nodiscard]] Result<Camera> camera(const World& world, const CameraChoice& choice,
                                      double aspect_ratio) const;

 private:
  [[nodiscard]] Result<void> go_on_stage(const PictureArguments& wanted);
  void frame_animation();
  [[nodiscard]] Ground ground_of_picture(const World& world, bool dark) const;

  PictureArguments wanted_;
  bool expects_ground_ = false;
  Scene at_rest_;  // for an animated scene, only its rig is kept
  SceneContents contents_;
  std::size_t cameras_ = 0;
  std::optional<ClipTime> time_;
  std::shared_ptr<const RenderScene> stage_;  // the prepared scene at rest; null: not animated
  std::optional<World> framed_;               // bounds of several times of the animation
  std::shared_ptr<const RenderScene> newest_;
};

}  // namespace asos
