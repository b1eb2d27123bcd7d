#pragma once

#include "renderer/geometry/view.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"

#include <utility>

namespace asos {

/// A snapshot as its workers see it: the same for all of them, and never changed.
struct PlannedRender {
  explicit PlannedRender(Snapshot of)
      : snapshot(std::move(of)),
        view(snapshot.camera, snapshot.settings.width, snapshot.settings.height,
             radius_around_origin(snapshot.scene->world().bounds)),
        plan(snapshot.settings) {}

  Snapshot snapshot;
  View view;
  WorkPlan plan;
};

}  // namespace asos
