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

/// The scene of a command line, read once, to be rendered at one or at several moments.
class OpenedScene {
 public:
  /// Reads it. Where the command line asks for some moment, the scene at rest is made ready, too:
  /// it says where the picture is seen from and how it is lit if the file does not.
  [[nodiscard]] static Result<OpenedScene> open(const PictureArguments& wanted);

  /// The moment that is asked for, or that the picture is of that settings are taken from; none:
  /// as the file's nodes place things.
  [[nodiscard]] const std::optional<ClipTime>& time() const { return time_; }
  [[nodiscard]] const SceneContents& contents() const { return contents_; }
  /// How many of the file's cameras are placed.
  [[nodiscard]] std::size_t cameras() const { return cameras_; }

  /// The scene ready to render at that moment, lit as `picture` says; the one that was asked for
  /// last is kept. Its boundaries may still be looked for.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> at(const std::optional<ClipTime>& time,
                                                              const PictureDescription& picture);
  /// The same at that moment of a scene that moves; it is not kept.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> posed(
      const std::optional<ClipTime>& time, const PictureDescription& picture) const;
  /// The scene as the file's nodes place it, where it moves; else as `at` has it.
  [[nodiscard]] Result<std::shared_ptr<const RenderScene>> at_rest(
      const PictureDescription& picture);
  /// Keeps this scene, lit and on its ground, in place of the one that was asked for last: `at` of
  /// the same time returns it. The hierarchies of the one before go.
  void keep(std::shared_ptr<const RenderScene> scene) { newest_ = std::move(scene); }
  /// The camera of a picture of `scene`, which is one of those above. Where the file has none, it
  /// frames all of the animation that is shown.
  [[nodiscard]] Result<Camera> camera(const RenderScene& scene, const CameraChoice& choice,
                                      double aspect_ratio) const;

 private:
  [[nodiscard]] Result<void> go_on_stage(const PictureArguments& wanted);
  void frame_animation();

  Scene at_rest_;  // of a scene that moves, its rig alone is kept
  SceneContents contents_;
  std::size_t cameras_ = 0;
  std::optional<ClipTime> time_;
  std::shared_ptr<const RenderScene> stage_;  // the scene at rest, made ready; null: nothing moves
  std::optional<World> framed_;               // at several times of the animation
  std::shared_ptr<const RenderScene> newest_;
};

}  // namespace asos
