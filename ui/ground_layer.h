#pragma once

#include "renderer/prepared/with_ground.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"

#include <functional>
#include <memory>

namespace asos::ui {

/// Adds the ground that the settings choose to the open scene, on its own thread. All members must
/// be called from one thread.
class GroundLayer {
 public:
  /// `wake` is called from that thread when `update` has a result to take.
  explicit GroundLayer(std::function<void()> wake);

  /// Puts a finished scene in place, and starts a new one if the scene's ground is not `wanted`.
  /// `busy`: the scene is being replaced with other lights or materials, which comes first. Call at
  /// least once a frame.
  void update(OpenScene& scene, Ground wanted, bool busy);

 private:
  struct Request {
    std::shared_ptr<const RenderScene> scene;
    Ground ground = Ground::off;
  };
  struct Built {
    Request request;
    Result<std::shared_ptr<const RenderScene>> scene;
  };

  std::weak_ptr<const Geometry> tried_;  // the geometry of the last try of tried_ground_
  Ground tried_ground_ = Ground::off;
  LatestJob<Request, Built> job_;
};

}  // namespace asos::ui
