#pragma once

#include "renderer/prepared/boundary_features.h"
#include "renderer/prepared/plane_section.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/world/object_spheres.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asos {

class MeshStore;
class Sky;

/// The properties of a moving scene that do not change with time, so that neither light nor camera
/// jumps. They follow from the scene at rest.
struct AnimationInvariants {
  glm::dvec3 origin{0.0};       ///< World::origin
  std::optional<double> floor;  ///< height of the lowest point; none: no surfaces
  Box whole;  ///< bounds of the scene with its hidden objects, for the ground; empty: none is
              ///< hidden
  bool has_default_lighting = false;  ///< the scene itself has almost no light
  std::vector<Light> rig;             ///< default lights in that case; relative to `origin`
  /// Walls block a studio's lights, so the default lights are inside.
  bool default_lighting_inside = false;
  MipChains mips;                  ///< of its images
  std::shared_ptr<const Sky> sky;  ///< the file's own surroundings; null: it has none
  /// Stores the meshes that keep their shape for all moments of an exposure. Null: each has its own
  /// copies.
  std::shared_ptr<MeshStore> meshes;
};

/// The parts of a scene that take long to build: its surfaces, with the hierarchies for rays and
/// boundaries. Immutable once shared by scenes with any lighting, except that the boundaries may
/// arrive later. Must not be moved, since both hierarchies refer to `world`.
struct Geometry {
  Geometry() = default;
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  World world;  ///< with the materials that the boundary search used
  RayScene rays;
  MipChains mips;
  PlaneSections sections;  ///< of the world
  std::vector<ObjectSphere> object_spheres;
  RenderFeatures render_features;  ///< for the surfaces and their own materials; see needs_of
  SceneNotes notes;                ///< of the file; see notes_of
  std::string name;
  std::string source;
  SceneContents contents;             ///< of the file
  std::optional<ClipTime> time;       ///< see Scene::time
  std::shared_ptr<PosableScene> rig;  ///< see Scene::rig
  AnimationInvariants stage;          ///< for the scene at other times
  double build_seconds = 0.0;         ///< without the boundaries
  BoundaryFeatures boundaries;        ///< last member: the search ends before its data is destroyed

  /// Returns the memory of geometry, textures with mip chains, and the hierarchies that exist so
  /// far.
  [[nodiscard]] double memory_mb() const;
};

/// Builds everything from a world, except the boundaries, whose search begins on demand. The caller
/// sets notes, names and the time. `lights`, `forced` and errors: as in RayScene::build; `known`:
/// as in MipChains; `use`, `known_rays`: as in RayScene::build.
[[nodiscard]] Result<std::shared_ptr<Geometry>> build_geometry(
    World world, std::span<const Light> lights, const RenderFeatures& forced,
    const MipChains* known = nullptr, BvhPurpose use = BvhPurpose::lasting,
    const RayScene* known_rays = nullptr);

}  // namespace asos
