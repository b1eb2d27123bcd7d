#include "ui/hidden_objects.h"

#include "renderer/scene/posable_scene.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace asos::ui {

namespace {

void take_out(Scene& scene, const std::vector<int>& hidden) {
  int place = -1;
  std::erase_if(scene.instances, [&](const Instance& instance) {
    if (!scene.shows_surface(instance)) return false;
    ++place;
    return std::binary_search(hidden.begin(), hidden.end(), place);
  });
}

/// Poses another rig's scene and removes some of its objects.
class RigWithout : public PosableScene, public std::enable_shared_from_this<RigWithout> {
 public:
  RigWithout(std::shared_ptr<PosableScene> whole, std::vector<int> hidden)
      : whole_(std::move(whole)), hidden_(std::move(hidden)) {}

  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    Result<Scene> scene = whole_->pose(time);
    if (!scene) return scene;
    take_out(*scene, hidden_);
    scene->rig = shared_from_this();
    return scene;
  }

 private:
  std::shared_ptr<PosableScene> whole_;
  std::vector<int> hidden_;
};

}  // namespace

void leave_out(Scene& scene, const std::vector<int>& hidden) {
  if (hidden.empty()) return;
  take_out(scene, hidden);
  if (scene.rig) scene.rig = std::make_shared<RigWithout>(scene.rig, hidden);
}

int place_among_all(int shown, const std::vector<int>& hidden) {
  for (const int place : hidden) shown += place <= shown ? 1 : 0;
  return shown;
}

}  // namespace asos::ui
