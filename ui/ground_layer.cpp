#include "ui/ground_layer.h"

#include "renderer/world/ground.h"

#include <optional>
#include <utility>

namespace asos::ui {

GroundLayer::GroundLayer(std::function<void()> wake)
    : job_(
          [](const Request& request) {
            return Built{request, with_ground(request.scene, request.ground)};
          },
          std::move(wake), Overtaken::kept) {}

void GroundLayer::update(OpenScene& scene, Ground wanted, bool busy) {
  std::optional<Built> done = job_.take_outcome();
  // Another scene may have been opened meanwhile, or its lights changed.
  if (done && !busy && scene.shared() == done->request.scene) {
    tried_ = scene->geometry;
    tried_ground_ = done->request.ground;
    if (!done->scene) return scene.report(done->scene.error());
    if (*done->scene != scene.shared()) scene.relight(std::move(*done->scene));
  }
  if (!scene || busy || job_.pending() || ground_of(scene->world()) == wanted) return;
  if (tried_.lock() == scene->geometry && tried_ground_ == wanted) return;
  job_.ask({scene.shared(), wanted});
}

}  // namespace asos::ui
