#pragma once

#include "renderer/rays/coplanar.h"
#include "renderer/rays/ray_layer.h"
#include "renderer/result.h"
#include "renderer/world/render_features.h"

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos::tracing {

/// Embree's device and scenes for a world, or for a motion through several
/// (RayScene::build_moving).
class EmbreeScene {
 public:
  EmbreeScene() = default;
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Builds the scene of up to RayScene::most_poses poses; may be called once. Surfaces that do not
  /// move are stored once. Errors: Embree's, and a light whose own part does not exist. Throws
  /// LoadStopped. `lights`, `forced` and `use`: as in RayScene::build. `known`: the scene of a
  /// world that has some of the same surfaces (Part::surfaces), whose layers are used again; null:
  /// none.
  [[nodiscard]] Result<void> build(std::span<const World* const> poses, const Transparency& open,
                                   std::span<const Light> lights, const RenderFeatures& forced,
                                   BvhPurpose use, const EmbreeScene* known);

  /// Returns the scenes to trace rays against in turn.
  [[nodiscard]] std::span<const RTCScene> scenes() const { return scenes_; }
  /// Returns whether the scenes contain surfaces that the world does not have: hiding_filter.
  [[nodiscard]] bool hides() const { return hides_; }
  /// Returns the geometries as numbered by `world`, one of the poses.
  [[nodiscard]] Geometries geometries(const World& world) const {
    return {numbers_.data(), world.placements.get()};
  }
  [[nodiscard]] Sides sides(const World& world) const {
    return {&world, single_sided_, any_single_sided_};
  }
  /// Returns the first pose.
  [[nodiscard]] const World& world() const { return *poses_.front(); }
  [[nodiscard]] const Coplanar& coplanar() const { return coplanar_; }
  /// Returns the ratio of Embree's lengths to the world's, a power of two, so that no digit is
  /// lost. It is 1 except for tiny and huge worlds. Embree treats triangles with sides below 1e-9
  /// as edge-on and reports one of their corners as the place of every hit. Products of three
  /// lengths have to fit a float.
  [[nodiscard]] float scale() const { return settings_.scale; }
  /// Returns whether any surface may transmit light.
  [[nodiscard]] bool see_through() const { return see_through_; }
  /// Returns whether any surface bounds a volume with attenuation.
  [[nodiscard]] bool volumes() const { return volumes_; }
  /// Returns the width of the processor's widest packets: 16, 8, 4 or 1.
  [[nodiscard]] int native_width() const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  void sort_parts(const World& world, std::span<const Light> lights);
  void find_sides(const World& world);
  /// Returns, by surface of the world's own, whether the poses differ.
  [[nodiscard]] std::vector<std::uint8_t> moving_surfaces() const;
  [[nodiscard]] static float scale_of(const World& world);
  void add_layers(const LayerSettings& settings, const EmbreeScene* known);
  [[nodiscard]] bool use_again(const Layer& layer);
  void number_as_built(const Layer& layer);

  std::vector<const World*> poses_;
  std::vector<std::uint8_t> group_of_part_;  // see LayerSource
  std::vector<std::uint8_t> single_sided_;   // by part
  bool any_single_sided_ = false;
  Coplanar coplanar_;
  bool see_through_ = false;
  bool volumes_ = false;
  LayerSettings settings_;
  std::shared_ptr<MeshDevice> owner_;  // of the device
  std::vector<std::shared_ptr<const Layer>> layers_;
  std::vector<RTCScene> scenes_;
  std::array<Numbers, Geometries::group_count> numbers_;
  std::array<std::vector<std::uint32_t>, Geometries::group_count>
      lists_;  // where layers have others
  bool hides_ = false;
};

}  // namespace asos::tracing
