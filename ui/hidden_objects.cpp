#include "ui/hidden_objects.h"

#include "renderer/prepared/without_objects.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace asos::ui {

namespace {

/// Numbers the objects with the same node and primitive.
class ObjectCounter {
 public:
  ObjectId next(int node, int primitive) { return {node, primitive, counts_[{node, primitive}]++}; }
  [[nodiscard]] int count(const ObjectId& object) const {
    return counts_.at({object.node, object.primitive});
  }

 private:
  std::map<std::pair<int, int>, int> counts_;
};

bool among(const std::vector<ObjectId>& ascending, const ObjectId& object) {
  return std::binary_search(ascending.begin(), ascending.end(), object);
}

void take_out(Scene& scene, const std::vector<ObjectId>& hidden) {
  ObjectCounter counter;
  std::erase_if(scene.instances, [&](const Instance& instance) {
    return scene.shows_surface(instance) &&
           among(hidden, counter.next(instance.node, instance.primitive));
  });
}

/// Poses another rig's scene and removes some of its objects.
class RigWithout : public PosableScene, public std::enable_shared_from_this<RigWithout> {
 public:
  RigWithout(std::shared_ptr<PosableScene> whole, std::vector<ObjectId> hidden)
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
  std::vector<ObjectId> hidden_;
};

}  // namespace

std::vector<ObjectId> objects_of(const SceneContents& contents, std::size_t count) {
  const auto at = [](const std::vector<int>& values, std::size_t i) {
    return i < values.size() ? values[i] : -1;
  };
  ObjectCounter counter;
  std::vector<ObjectId> objects;
  objects.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    objects.push_back(
        counter.next(at(contents.object_nodes, i), at(contents.object_primitives, i)));
  for (ObjectId& object : objects) object.copies = counter.count(object);
  return objects;
}

Result<std::shared_ptr<const RenderScene>> scene_without(
    const std::shared_ptr<const RenderScene>& whole, const std::vector<ObjectId>& hidden) {
  if (hidden.empty()) return whole;
  const Geometry& geometry = *whole->geometry;
  std::vector<std::uint8_t> flags;
  for (const ObjectId& object :
       objects_of(geometry.contents, objects_without_ground(geometry.world)))
    flags.push_back(among(hidden, object));
  auto rig = geometry.rig ? std::make_shared<RigWithout>(geometry.rig, hidden) : nullptr;
  return without_objects(whole, flags, std::move(rig));
}

void leave_out(Scene& scene, const std::vector<ObjectId>& hidden) {
  if (hidden.empty()) return;
  take_out(scene, hidden);
  if (scene.rig) scene.rig = std::make_shared<RigWithout>(scene.rig, hidden);
}

void mark_as_lights(Scene& scene, const std::vector<ObjectId>& objects) {
  if (objects.empty()) return;
  ObjectCounter counter;
  for (Instance& instance : scene.instances) {
    if (!scene.shows_surface(instance)) continue;
    const ObjectId object = counter.next(instance.node, instance.primitive);
    instance.shows_light |= std::find(objects.begin(), objects.end(), object) != objects.end();
  }
}

int place_among_all(int shown, const std::vector<int>& hidden) {
  for (const int place : hidden) shown += place <= shown ? 1 : 0;
  return shown;
}

}  // namespace asos::ui
