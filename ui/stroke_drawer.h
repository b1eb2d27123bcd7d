#pragma once

#include "renderer/prepared/with_strokes.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"
#include "ui/preview_render.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace asos::ui {

/// Lets the open scene's lines and points follow the camera: draws them anew, on a thread of its
/// own, as soon as the camera rests; while it moves they stay as they were. Scenes without any cost
/// nothing. All members are for one thread.
class StrokeDrawer {
 public:
  /// `wake` is called from the thread when `update` has something to do.
  explicit StrokeDrawer(std::function<void()> wake);

  /// Hands over what is drawn, and asks for more where the scene is not drawn for `subject`.
  /// `busy`: the scene is being replaced in other lights or materials, which has to be done first.
  /// Call once or more a frame.
  void update(OpenScene& scene, const PreviewRender::Subject& subject, bool busy,
              double now_seconds);
  /// Takes note that the scene has come with lines and points drawn for this.
  void adopt(const OpenScene& scene, const StrokePicture& picture, std::uint64_t camera_revision);
  /// When `update` next has something to do of its own accord, in seconds from now; none: when
  /// woken.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    StrokePicture picture;
    std::uint64_t camera_revision = 0;
  };
  struct Drawn {
    Request request;
    Result<std::shared_ptr<const RenderScene>> scene;
  };
  /// What a scene's lines and points depend on besides themselves.
  struct Wanted {
    std::uint64_t camera_revision = 0;
    int height = 0;
    double width = 0.0;
    bool operator==(const Wanted&) const = default;
  };
  [[nodiscard]] static Wanted wanted_of(const Request& request);
  void take(OpenScene& scene, bool busy);
  [[nodiscard]] bool is_drawn(const RenderScene& scene, const Wanted& wanted) const;

  std::weak_ptr<const Geometry> drawn_;  // or could not be drawn
  Wanted drawn_for_;
  Wanted newest_;
  double newest_since_ = 0.0;
  std::optional<double> due_;  // a time
  LatestJob<Request, Drawn> job_;
};

}  // namespace asos::ui
