#pragma once

#include "renderer/rays/filters.h"
#include "renderer/rays/mesh_device.h"
#include "renderer/world/world.h"

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// The hierarchies of a world: one for each layer of its surfaces, so that a change of one layer
// leaves the others as they are. Internal to this folder.

namespace asos::tracing {

/// The layers of a world's surfaces, in the order in which rays are traced against them.
enum class LayerKind : std::uint8_t {
  solids,  ///< of the scene, except shared meshes
  ground,
  lines,   ///< and points
  places,  ///< instances of shared meshes
};
inline constexpr std::size_t layer_kinds = 4;

/// The numbers of Embree's geometries. Kinds of meshes, then these kinds of lights' own parts, then
/// six such groups for faces of shapes, then three kinds of lines and points, then the ground.
inline constexpr unsigned first_group_of_faces = 6;
inline constexpr unsigned first_group_of_lines = 12;
inline constexpr unsigned group_of_ground = 15;
/// The group of a part without surfaces of its own.
inline constexpr std::uint8_t no_group = 255;

[[nodiscard]] inline LayerKind layer_of(unsigned group) {
  const unsigned of_kind = group % Geometries::still_count;
  if (of_kind == group_of_ground) return LayerKind::ground;
  return of_kind >= first_group_of_lines ? LayerKind::lines : LayerKind::solids;
}

/// The properties that all surfaces of a scene share.
struct LayerSettings {
  Transparency open;
  float scale = 1.0f;
  bool filtered = false;      ///< all geometries have filters
  bool forced_faces = false;  ///< solids have a geometry of faces, even without any
  BvhPurpose use = BvhPurpose::lasting;

  bool operator==(const LayerSettings&) const = default;
};

/// The worlds to build layers from: one, or the poses of a motion.
struct LayerSource {
  std::span<const World* const> poses;
  /// The group of each part's triangles, if they stand still; no_group: it has none. Faces are in
  /// the group that is `first_group_of_faces` later.
  std::span<const std::uint8_t> group_of_part;
  std::span<const std::uint8_t> moving;  ///< by surface of the first pose; empty: none moves

  [[nodiscard]] const World& world() const { return *poses.front(); }
};

/// A hierarchy over some surfaces, immutable and shared by the scenes that have them. It keeps the
/// arrays that Embree reads.
class Layer {
 public:
  /// Consecutive surfaces of one part in one group.
  struct Run {
    std::uint64_t surfaces = 0;  ///< Part::surfaces
    std::uint32_t part = 0;      ///< in the world that the layer was built from
    std::uint32_t first = 0, count = 0;
    std::uint8_t group = 0;
  };

  /// Builds a layer; null: it would have no surface. Throws LoadStopped.
  [[nodiscard]] static std::shared_ptr<const Layer> build(const std::shared_ptr<MeshDevice>& device,
                                                          LayerKind kind, const LayerSource& source,
                                                          const LayerSettings& settings);
  ~Layer();
  Layer(const Layer&) = delete;
  Layer& operator=(const Layer&) = delete;

  [[nodiscard]] LayerKind kind() const { return kind_; }
  [[nodiscard]] RTCScene scene() const { return scene_; }
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  [[nodiscard]] const Group& group(std::size_t id) const { return groups_[id]; }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  Layer(const std::shared_ptr<MeshDevice>& device, LayerKind kind, const LayerSettings& settings)
      : device_(device), kind_(kind), settings_(settings) {}
  void find_runs(const LayerSource& source);
  void make_groups(const World& world);
  void keep_arrays(const LayerSource& source);
  void place_vertices(const World& world);
  void make_scene(const LayerSource& source);
  void add(unsigned id, std::size_t poses);
  [[nodiscard]] bool needs_faces() const {
    return kind_ == LayerKind::solids && settings_.forced_faces;
  }
  [[nodiscard]] bool quickly_built() const;
  [[nodiscard]] RTCGeometry make_triangles(const Group& group, std::size_t poses) const;
  void add_filters(RTCGeometry geometry, const Group& group) const;
  [[nodiscard]] OwnedScene scene_of_mesh(const World& mesh) const;
  void add_places(const LayerSource& source);
  void set_transforms(RTCGeometry geometry, std::span<const World* const> poses,
                      std::size_t place) const;

  std::shared_ptr<MeshDevice> device_;
  LayerKind kind_;
  LayerSettings settings_;
  std::vector<Run> runs_;
  std::array<Group, Geometries::group_count> groups_;
  std::size_t count_ = 0;  // surfaces
  RTCBuildQuality quality_ = RTC_BUILD_QUALITY_MEDIUM;
  RTCScene scene_ = nullptr;
  std::int64_t bytes_ = 0;  // of Embree
  // Read by Embree.
  std::vector<std::shared_ptr<const std::vector<glm::vec3>>> positions_;  // by pose
  std::vector<std::vector<float>> copies_;                                // those that are needed
  std::vector<const float*> corners_;                                     // by pose
  std::size_t vertices_ = 0;
  std::shared_ptr<const std::vector<glm::uvec3>> triangles_;
  std::vector<std::vector<ShapeFace>> faces_;  // by pose
  std::shared_ptr<const Placements> placements_;
};

}  // namespace asos::tracing
