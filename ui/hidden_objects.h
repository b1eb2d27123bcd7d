#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <array>
#include <compare>
#include <cstddef>
#include <memory>
#include <vector>

namespace asos::ui {

/// An object of a scene in all its poses: an instance with surfaces. Indices among objects differ
/// between poses if an animation changes KHR_node_visibility.
struct ObjectId {
  int node = -1;       ///< Instance::node
  int primitive = -1;  ///< Instance::primitive
  int copy = 0;        ///< its position among the objects with the same node and primitive
  int copies = 1;      ///< the number of these; no part of the identity

  [[nodiscard]] std::array<int, 3> identity() const { return {node, primitive, copy}; }
  auto operator<=>(const ObjectId& other) const { return identity() <=> other.identity(); }
  bool operator==(const ObjectId& other) const { return identity() == other.identity(); }
};

/// Returns the first `count` objects of a pose, in the order of World::parts. Scenes without nodes
/// have no SceneContents::object_nodes.
[[nodiscard]] std::vector<ObjectId> objects_of(const SceneContents& contents, std::size_t count);

/// Returns a prepared scene without these objects (without_objects). `whole` hides nothing;
/// `hidden`: as in leave_out. The remaining objects still move.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> scene_without(
    const std::shared_ptr<const RenderScene>& whole, const std::vector<ObjectId>& hidden);

/// Removes objects from a loaded scene. `hidden` is ascending; objects that the scene does not have
/// are ignored. The remaining objects still move.
void leave_out(Scene& scene, const std::vector<ObjectId>& hidden);

/// Marks objects as visible surfaces of lights of the scene, which emit no light themselves.
void mark_as_lights(Scene& scene, const std::vector<ObjectId>& objects);

/// Returns the index among all objects of the one with index `shown` among those not in `hidden`
/// (ascending).
[[nodiscard]] int place_among_all(int shown, const std::vector<int>& hidden);

}  // namespace asos::ui
