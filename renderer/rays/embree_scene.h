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
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace asos::tracing {

/// Embree's device and scene for a world. Must not be moved: Embree keeps pointers into it.
class EmbreeScene {
 public:
  EmbreeScene() = default;
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  /// Builds the scene; may be called once. Errors: Embree's, and a light whose own part does not
  /// exist. Throws LoadStopped. `lights`, `forced` and `use`: as in RayScene::build.
  [[nodiscard]] Result<void> build(const World& world, const Transparency& open,
                                   std::span<const Light> lights, const RenderFeatures& forced,
                                   BvhPurpose use);

  [[nodiscard]] RTCScene scene() const { return scene_; }
  [[nodiscard]] Geometries geometries() const {
    return {groups_.data(), sides_.world->placements.get()};
  }
  [[nodiscard]] const Sides& sides() const { return sides_; }
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
  struct Errors {
    std::mutex mutex;
    std::string first;
    static void note(void* self, RTCError code, const char* text);
  };

  void sort_surfaces(const World& world, const Transparency& open, std::span<const Light> lights);
  void place_vertices(const World& world);
  void choose_scale(const World& world);
  [[nodiscard]] RTCGeometry make_triangles(Group& group, const World& world);
  /// Returns whether Embree's quick builder may be used: for a single geometry of more than a few
  /// triangles. With several geometries, it asserts that none collapses to a point, and Debian's
  /// Embree keeps its assertions.
  [[nodiscard]] bool quickly_built() const;
  void add(unsigned id, const World& world, const RenderFeatures& forced, RTCBuildQuality quality);
  void add_filters(RTCGeometry geometry, const Group& group, const RenderFeatures& forced) const;
  /// Adds a scene for each shared mesh, and its instances.
  void add_places(const World& world, const RenderFeatures& forced, RTCBuildQuality quality);
  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  using OwnedScene = std::unique_ptr<RTCSceneTy, Release>;
  [[nodiscard]] OwnedScene scene_of_mesh(const World& mesh, Group& group,
                                         const RenderFeatures& forced, RTCBuildQuality quality);

  // Meshes: three kinds of surfaces, then these kinds of lights' own parts. Then six such groups
  // for faces of shapes, then three kinds of lines and points.
  std::array<Group, Geometries::group_count> groups_;
  std::vector<Group> mesh_groups_;  // of shared meshes
  Sides sides_;
  Coplanar coplanar_;
  bool see_through_ = false;
  bool volumes_ = false;
  float scale_ = 1.0f;
  const float* corners_ = nullptr;  // vertices: the world's, or a copy
  std::vector<float> vertices_;     // the copy, if needed
  Errors errors_;
  std::atomic<std::int64_t> device_bytes_{0};
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace asos::tracing
