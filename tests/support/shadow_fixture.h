#pragma once

#include "renderer/lights/light_intersections.h"
#include "renderer/shading/shade.h"
#include "renderer/shadows/shadow.h"
#include "renderer/world/render_features.h"
#include "tests/support/tiny_world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace asos::test {

inline Leaf leaf_of(const LeafRegion& region, float root_side, std::uint64_t seed) {
  Leaf leaf;
  leaf.region = region;
  leaf.root_side = root_side;
  leaf.seed = seed;
  return leaf;
}

/// Sees nothing: for receivers on flat surfaces, or on none.
class NoView final : public PatchView {
 public:
  void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
            RenderStatistics& /*counts*/) override {
    seen.assign(at.size(), {});
  }
};

/// A world whose first light shines on single receivers outside the world's surfaces: tests shadow
/// pyrays, one per receiver.
class ShadowFixture {
 public:
  ShadowFixture(World world, const Light& light, ShadowRules rules = {})
      : world_(std::move(world)),
        source_(light),
        features_(world_),
        rays_(std::move(RayScene::build(world_, alpha_at, {&source_, 1}).value())),
        rules_(rules),
        light_(prepare_light(light)) {
    rules_.see_through = features_.opacity_unbounded();
    light_.intersections = find_light_intersections(world_, {&light_, 1}).front();
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const FeatureSet& features() const { return features_; }
  [[nodiscard]] const RayScene& rays() const { return rays_; }
  [[nodiscard]] const Light& source() const { return source_; }
  [[nodiscard]] const PreparedLight& light() const { return light_; }
  [[nodiscard]] const RenderStatistics& counts() const { return counts_; }

  /// Visibility of the light from a receiver, 0 to 1, for a leaf that is a whole pixel.
  [[nodiscard]] double visibility(const Receiver& receiver) {
    SurfacePoint point{.position = glm::vec3(receiver.position),
                       .geometric_normal = glm::vec3(receiver.geometric),
                       .shading_normal = glm::vec3(receiver.normal)};
    const Frame facing = Frame::pyramid({0, 0, 0}, {-0.5, -0.5, -1}, {1, 0, 0}, {0, 1, 0});
    return visibility(point, facing, leaf_of({{0.0f, 0.0f, 1.0f}, {}}, 1.0f, 1), 1);
  }

  /// Visibility for a leaf of the pyray through `eye` that shows `point`. `layer` 0: the leaf's
  /// square is on the point's plane; 1: only the point is known, because it is on no triangle.
  [[nodiscard]] double visibility(const SurfacePoint& point, const Frame& eye, const Leaf& leaf,
                                  int layer = 0) {
    const ShadowScene scene{world_, features_, rays_};
    ShadowGroups groups(scene);
    groups.reset(1);
    ShadowContext block{.scene = &scene,
                        .rules = rules_,
                        .frame = &eye,
                        .view = &view_,
                        .groups = &groups,
                        .work = &work_};
    return light_visibility(block, {light_, 0, point, glm::vec3(1.0f), glm::vec3(1.0f), layer},
                            leaf, counts_)
        .value.x;
  }

 private:
  World world_;
  Light source_;
  FeatureSet features_;
  RayScene rays_;
  ShadowRules rules_;
  PreparedLight light_;
  NoView view_;
  ShadowWorkspace work_;
  RenderStatistics counts_;
};

}  // namespace asos::test
