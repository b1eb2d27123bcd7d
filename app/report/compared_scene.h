#pragma once

#include "app/opened_scene.h"
#include "renderer/study/plan.h"

#include <memory>
#include <optional>
#include <string>

namespace asos {

/// A scene and its camera, as all methods of a study render them.
struct ComparedScene {
  std::shared_ptr<const RenderScene> scene;
  Camera camera;
};

/// Prepares a scene at a time of its animation, with its boundaries, under the sky of `look`. Lines
/// have their own width. Errors: an empty scene, a camera that is not there.
[[nodiscard]] Result<ComparedScene> compared_scene(OpenedScene& opened,
                                                   const std::optional<ClipTime>& time,
                                                   const PictureArguments& wanted,
                                                   const StudyPlan& plan, const StudyLook& look);

/// The time in UTC, as 2026-01-31T12:00:00Z.
[[nodiscard]] std::string utc_now();

}  // namespace asos
