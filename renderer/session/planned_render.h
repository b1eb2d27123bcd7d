#pragma once

#include "renderer/comparison/method.h"
#include "renderer/geometry/view.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace asos {

/// A snapshot with its plan, shared by all workers and immutable.
struct PlannedRender {
  explicit PlannedRender(Snapshot of)
      : snapshot(std::move(of)),
        view(viewed_camera(*snapshot.scene, snapshot.camera, snapshot.settings),
             snapshot.settings.width, snapshot.settings.height,
             radius_around_origin(snapshot.scene->world().bounds)),
        motion(moving_picture(*snapshot.scene,
                              viewed_camera(*snapshot.scene, snapshot.camera, snapshot.settings),
                              snapshot.settings)),
        plan(snapshot.settings),
        unlit(has_unlit(snapshot.scene->world())) {}

  /// The job of a block.
  [[nodiscard]] BlockJob job(const RenderSettings& settings, const PixelRect& block,
                             const std::stop_token& stop) const {
    return {*snapshot.scene, view, settings, block, stop, motion ? &*motion : nullptr};
  }

  Snapshot snapshot;
  View view;
  std::optional<MovingPicture> motion;  ///< while the shutter is open; none: one moment
  WorkPlan plan;
  /// Some surface may be unlit: tiles hold the unlit part of pixels.
  bool unlit = false;
};

}  // namespace asos
