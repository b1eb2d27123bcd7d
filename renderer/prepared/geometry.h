#pragma once

#include "renderer/prepared/boundary_features.h"
#include "renderer/prepared/plane_section.h"
#include "renderer/prepared/stage.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/result.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/world/needs.h"
#include "renderer/world/object_spheres.h"
#include "renderer/world/world.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asos {

/// The parts of a scene that take long to build: its surfaces, with the hierarchies of its rays and
/// its boundaries. Immutable once shared, by scenes in whatever light, but that the boundaries may
/// come later than all else; stays where it was made, for both hierarchies refer to `world`.
struct Geometry {
  Geometry() = default;
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  World world;  ///< with the materials that its boundaries were looked for by
  RayScene rays;
  MipChains mips;
  PlaneSections sections;  ///< of its surfaces
  std::vector<ObjectSphere> object_spheres;
  SceneNeeds needs;  ///< those of the surfaces and of their own materials; see needs_of
  SceneNotes notes;  ///< of the file; see notes_of
  std::string name;
  std::string source;
  SceneContents contents;        ///< of the file
  std::optional<ClipTime> time;  ///< see Scene::time
  std::shared_ptr<Rig> rig;      ///< see Scene::rig
  Stage stage;                   ///< for the scene at other times
  double build_seconds = 0.0;    ///< without the boundaries
  BoundaryFeatures boundaries;   ///< last: their search ends before what it looks at goes

  /// Of geometry, textures with their mip chains, and both hierarchies as far as they are there.
  [[nodiscard]] double memory_mb() const;
};

/// Builds all that follows from a world but for the boundaries, which go on being looked for;
/// notes, names and the time are left to the caller. `lights`, `forced` and errors: as
/// RayScene::build's; `known`: as MipChains's; `use`: as RayScene::build's.
[[nodiscard]] Result<std::shared_ptr<Geometry>> build_geometry(
    World world, std::span<const Light> lights, const SceneNeeds& forced,
    const MipChains* known = nullptr, HierarchyUse use = HierarchyUse::lasting);

}  // namespace asos
