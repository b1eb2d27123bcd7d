#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/result.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/world/needs.h"
#include "renderer/world/object_spheres.h"
#include "renderer/world/world.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asos {

/// The parts of a scene that take long to build: its surfaces, with the hierarchies of its rays and
/// its boundaries. Immutable once shared, by scenes in whatever light; stays where it was made, for
/// `rays` points into `world`.
struct Geometry {
  Geometry() = default;
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  World world;  ///< with the materials that its boundaries were looked for by
  RayScene rays;
  FeatureSet features;
  MipChains mips;
  std::vector<ObjectSphere> object_spheres;
  SceneNeeds needs;  ///< those of the surfaces and of their own materials
  SceneNotes notes;
  std::string name;
  std::string source;
  double build_seconds = 0.0;
  double memory_mb = 0.0;  ///< of geometry, textures with their mip chains, and both hierarchies
};

/// Builds all that follows from a world; notes, names and the time are left to the caller.
/// `lights`, `forced` and errors: as RayScene::build's.
[[nodiscard]] Result<std::shared_ptr<Geometry>> build_geometry(World world,
                                                               std::span<const Light> lights,
                                                               const SceneNeeds& forced);

}  // namespace asos
