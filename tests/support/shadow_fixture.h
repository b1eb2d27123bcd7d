#pragma once

#include "renderer/lights/light_cuts.h"
#include "renderer/shading/shade.h"
#include "renderer/shadows/shadow_pyrays.h"
#include "renderer/world/needs.h"
#include "tests/support/tiny_world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace asos::test {

/// Sees nothing: for receivers that lie on flat surfaces, or on none.
class NoView final : public PatchView {
 public:
  void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
            RenderStatistics& /*counts*/) const override {
    seen.assign(at.size(), {});
  }
};

/// A world whose first light shines on single receivers that are no part of it: what shadow pyrays
/// say of each, one pyray a receiver.
class ShadowFixture {
 public:
  ShadowFixture(World world, const Light& light, ShadowRules settings = {})
      : world_(with_light(std::move(world), light)),
        features_(world_),
        rays_(std::move(RayScene::build(world_, alpha_at).value())),
        settings_(settings),
        light_(prepare_light(world_.lights.front())) {
    settings_.see_through = find_needs(world_).varying_opacity;
    light_.cuts = find_light_cuts(world_).front();
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const FeatureSet& features() const { return features_; }
  [[nodiscard]] const RayScene& rays() const { return rays_; }
  [[nodiscard]] const PreparedLight& light() const { return light_; }
  [[nodiscard]] const RenderStatistics& counts() const { return counts_; }

  /// The share of the light that a receiver sees, 0 to 1, by a leaf that is a whole pixel.
  [[nodiscard]] double lit_share(const Receiver& receiver) {
    SurfacePoint point;
    point.position = glm::vec3(receiver.position);
    point.shading_normal = glm::vec3(receiver.normal);
    point.geometric_normal = glm::vec3(receiver.geometric);
    const Frame facing = Frame::pyramid({0, 0, 0}, {-0.5, -0.5, -1}, {1, 0, 0}, {0, 1, 0});
    return lit_share(point, facing, {{{0.0f, 0.0f, 1.0f}, {}}, 1.0f, 1}, 1);
  }

  /// The share of a leaf of the pyray through `eye` that is lit; the leaf shows `point`.
  /// `layer`: 0: the leaf's square lies on the point's plane; 1: the point is all there is.
  [[nodiscard]] double lit_share(const SurfacePoint& point, const Frame& eye,
                                 const ShadedLeaf& leaf, int layer = 0) {
    const ShadowScene scene{world_, features_, rays_};
    ShadowGroups groups(scene);
    groups.reset(world_.lights.size());
    ShadowPyrays pyrays(scene, settings_, eye, view_, groups, work_);
    pyrays.set_leaf(leaf);
    glm::vec3 radiance(0.0f);
    pyrays.add({light_, 0, point, glm::vec3(1.0f), glm::vec3(1.0f), layer}, radiance, counts_);
    return static_cast<double>(radiance.x);
  }

 private:
  static World with_light(World world, const Light& light) {
    world.lights = {light};
    return world;
  }

  World world_;
  FeatureSet features_;
  RayScene rays_;
  ShadowRules settings_;
  PreparedLight light_;
  NoView view_;
  ShadowWorkspace work_;
  RenderStatistics counts_;
};

}  // namespace asos::test
