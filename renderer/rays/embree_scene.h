#pragma once

#include "renderer/rays/coplanar.h"
#include "renderer/rays/filters.h"
#include "renderer/result.h"
#include "renderer/world/render_features.h"

#include <embree3/rtcore.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace asos::tracing {

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using OwnedScene = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// A device of Embree, with the hierarchies of meshes that several scenes on it share.
class MeshDevice {
 public:
  MeshDevice();
  MeshDevice(const MeshDevice&) = delete;
  MeshDevice& operator=(const MeshDevice&) = delete;
  ~MeshDevice();
  /// Returns the device for the moments of animations, which may be more than Embree can have
  /// devices, and show the same meshes.
  [[nodiscard]] static std::shared_ptr<MeshDevice> common();

  /// Null: Embree does not start.
  [[nodiscard]] RTCDevice get() const { return device_; }
  /// Returns the first error since the last call; empty: none.
  [[nodiscard]] std::string take_error();
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }
  /// Returns the hierarchy of a mesh, which belongs to the caller. `build` makes it, unless there
  /// is one from a world that still exists, with filters or without.
  [[nodiscard]] OwnedScene scene_of(const std::shared_ptr<const World>& mesh, bool filtered,
                                    const std::function<OwnedScene()>& build);

 private:
  struct Errors {
    std::mutex mutex;
    std::string first;
    static void note(void* self, RTCError code, const char* text);
  };
  struct Known {
    std::weak_ptr<const World> mesh;
    bool filtered;
    RTCScene scene;
  };

  Errors errors_;
  std::atomic<std::int64_t> bytes_{0};
  RTCDevice device_ = nullptr;
  std::mutex mutex_;
  std::vector<Known> scenes_;
};

/// Embree's device and scene for a world, or for a motion through several (RayScene::build_moving).
/// Must not be moved: Embree keeps pointers into it.
class EmbreeScene {
 public:
  EmbreeScene() = default;
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  /// Builds the scene of up to RayScene::most_poses poses; may be called once. Surfaces that do not
  /// move are stored once. Errors: Embree's, and a light whose own part does not exist. Throws
  /// LoadStopped. `lights`, `forced` and `use`: as in RayScene::build.
  [[nodiscard]] Result<void> build(std::span<const World* const> poses, const Transparency& open,
                                   std::span<const Light> lights, const RenderFeatures& forced,
                                   BvhPurpose use);

  [[nodiscard]] RTCScene scene() const { return scene_; }
  /// Returns the geometries as numbered by `world`, one of the poses.
  [[nodiscard]] Geometries geometries(const World& world) const {
    return {groups_.data(), world.placements.get()};
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
  [[nodiscard]] float scale() const { return scale_; }
  /// Returns whether any surface may transmit light.
  [[nodiscard]] bool see_through() const { return see_through_; }
  /// Returns whether any surface bounds a volume with attenuation.
  [[nodiscard]] bool volumes() const { return volumes_; }
  /// Returns the width of the processor's widest packets: 16, 8, 4 or 1.
  [[nodiscard]] int native_width() const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  void sort_surfaces(const World& world, const Transparency& open, std::span<const Light> lights);
  /// Returns, by surface of the world's own, whether the poses differ.
  [[nodiscard]] std::vector<std::uint8_t> moving_surfaces() const;
  void place_vertices(const World& world);
  void choose_scale(const World& world);
  [[nodiscard]] RTCGeometry make_triangles(Group& group, const World& world, std::size_t poses);
  /// Returns whether Embree's quick builder may be used: for a single geometry of more than a few
  /// triangles. With several geometries, it asserts that none collapses to a point, and Debian's
  /// Embree keeps its assertions.
  [[nodiscard]] bool quickly_built() const;
  void add(unsigned id, const World& world, const RenderFeatures& forced, RTCBuildQuality quality);
  void add_filters(RTCGeometry geometry, const Group& group, const RenderFeatures& forced) const;
  /// Adds a scene for each shared mesh, and its instances.
  void add_places(const World& world, const RenderFeatures& forced, RTCBuildQuality quality);
  void set_transforms(RTCGeometry geometry, std::size_t place) const;
  [[nodiscard]] OwnedScene scene_of_mesh(const World& mesh, const RenderFeatures& forced,
                                         RTCBuildQuality quality) const;

  // Meshes: three kinds of surfaces, then these kinds of lights' own parts. Then six such groups
  // for faces of shapes, then three kinds of lines and points. Then all of these again, for moving
  // surfaces.
  std::array<Group, Geometries::group_count> groups_;
  std::vector<const World*> poses_;
  std::vector<std::uint8_t> single_sided_;  // by part
  bool any_single_sided_ = false;
  Coplanar coplanar_;
  bool see_through_ = false;
  bool volumes_ = false;
  float scale_ = 1.0f;
  std::vector<const float*> corners_;         // vertices by pose: the world's, or a copy
  std::vector<std::vector<float>> vertices_;  // the copies that are needed
  std::shared_ptr<MeshDevice> owner_;         // of the device
  std::int64_t device_bytes_ = 0;             // for this scene
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace asos::tracing
