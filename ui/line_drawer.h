#pragma once

#include "renderer/prepared/with_lines.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"
#include "ui/preview_render.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace asos::ui {

/// Redraws the open scene's lines and points for the current camera on its own thread, once the
/// camera is still; until then they stay as they were. Scenes without lines and points cost
/// nothing. All members must be called from one thread.
class LineDrawer {
 public:
  /// `wake` is called from that thread when `update` has a result to take.
  explicit LineDrawer(std::function<void()> wake);

  /// Puts a finished scene in place, and starts a new one if the scene's lines and points were not
  /// drawn for `subject`. `busy`: the scene is being replaced with other lights or materials, which
  /// comes first. Call at least once a frame.
  void update(OpenScene& scene, const PreviewRender::Subject& subject, bool busy,
              double now_seconds);
  /// Call when the scene has come with lines and points drawn for this picture.
  void adopt(const OpenScene& scene, const LinePicture& picture, std::uint64_t camera_revision);
  /// Seconds until `update` is due without any event; none: only after events.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    LinePicture picture;
    std::uint64_t camera_revision = 0;
  };
  struct Drawn {
    Request request;
    Result<std::shared_ptr<const RenderScene>> scene;
  };
  /// Everything that a drawing of lines and points depends on.
  struct Wanted {
    std::uint64_t camera_revision = 0;
    int height = 0;
    double width = 0.0;
    bool operator==(const Wanted&) const = default;
  };
  [[nodiscard]] static Wanted wanted_of(const Request& request);
  void take(OpenScene& scene, bool busy);
  [[nodiscard]] bool is_drawn(const RenderScene& scene, const Wanted& wanted) const;

  std::weak_ptr<const Geometry> drawn_;  // geometry of the last drawing, also of a failed one
  Wanted drawn_for_;
  Wanted newest_;
  double newest_since_ = 0.0;
  std::optional<double> due_;  // time of the next drawing
  LatestJob<Request, Drawn> job_;
};

}  // namespace asos::ui
