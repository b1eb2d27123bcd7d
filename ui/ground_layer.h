#pragma once

#include "renderer/prepared/with_ground.h"
#include "ui/latest_job.h"
#include "ui/open_scene.h"

#include <functional>
#include <memory>

namespace asos::ui {

/// Puts the open scene on the ground that the settings ask for, on a thread of its own. All members
/// are for one thread.
class GroundLayer {
 public:
  /// `wake` is called from the thread when `update` has something to do.
  explicit GroundLayer(std::function<void()> wake);

  /// Hands over what was built, and asks for it where the scene stands on another ground than
  /// `wanted`. `busy`: the scene is being replaced in other lights or materials, which has to be
  /// done first. Call once or more a frame.
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

  std::weak_ptr<const Geometry> tried_;  // with this ground, which it did not get
  Ground tried_ground_ = Ground::off;
  LatestJob<Request, Built> job_;
};

}  // namespace asos::ui
