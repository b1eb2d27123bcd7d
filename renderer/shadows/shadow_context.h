#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/kernels/light_kernel.h"
#include "renderer/pyray/rules.h"
#include "renderer/pyray/tracer.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf.h"
#include "renderer/shadows/light_pyramid_caster.h"
#include "renderer/shadows/patch_caster.h"
#include "renderer/shadows/patch_points.h"
#include "renderer/shadows/patch_view.h"
#include "renderer/shadows/shadow_groups.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace asos {

/// A batch of rays between a patch and a light.
struct SampledRays {
  ShadowRayBatch rays;
  std::vector<glm::vec3> transmittances;  ///< fraction of each that arrives

  /// Returns a ray's weight: unshadowed irradiance, or radiance by RayWeighting.
  [[nodiscard]] float weight(std::size_t ray) const { return rays.carried[0][ray]; }
  /// Traces the batch. `own_part`: see RayScene.
  void trace(const RayScene& scene, std::int32_t own_part);
};

class AreaShadows;

/// The rules for shadows on a viewer's leaves.
struct ShadowRules {
  /// Replaces the shadows of extended lights; null: as exact as `error_budget`.
  const AreaShadows* area_shadows = nullptr;
  ErrorBudget error_budget;  ///< for the viewer's pyrays; those of shadows get the remaining levels
  const SubdivisionVariant* variant = nullptr;  ///< for shadow pyrays; null: the engine's own way
  /// Some surfaces of the scene have varying transmittance, or holes, without boundaries
  /// (FeatureSet::opacity_unbounded).
  bool see_through = true;
};

/// Scratch memory of shadow pyrays. Holds no result.
struct ShadowWorkspace {
  Tracer tracer;
  LightPyramidCaster pyramid_caster;
  PatchCaster patch_caster;
  std::vector<BorderEdge> border;
  std::vector<double> ends;
  PatchPoints patch;
  SampledRays sampled;
};

/// The surroundings that the shadows of one viewer's block share. Stores pointers.
struct ShadowContext {
  const ShadowScene* scene = nullptr;
  ShadowRules rules;
  std::size_t lights = 1;        ///< in the scene
  const Frame* frame = nullptr;  ///< that of the viewer's block
  PatchView* view = nullptr;
  ShadowGroups* groups = nullptr;
  ShadowWorkspace* work = nullptr;
};

/// A query for the visibility of a light from a leaf.
struct ShadowQuery {
  const Illumination& lit;
  const Leaf& leaf;
  SearchBounds found;  ///< where boundaries between the leaf and the light may be

  /// Returns the light's unshadowed contribution in display units, at most 1.
  [[nodiscard]] double intensity() const;
  /// Returns whether rays from all over the patch replace an exact shadow with this error, at this
  /// cost in rays.
  [[nodiscard]] bool takes_rays(const ErrorBudget& error_budget, double cost,
                                const ErrorBound& exact = {}) const {
    return choose(error_budget, leaf.weight, exact, {cost, {}, intensity()}) == Estimator::samples;
  }
};

/// Returns the receiver of a light: a point clear of the surface. For a distant light it is on the
/// way to the light's centre, so that shadows stay in place.
[[nodiscard]] Receiver receiver_above(const SurfacePoint& point, const PreparedLight& light);

/// Returns two numbers in [0, 1).
[[nodiscard]] glm::dvec2 unit_pair_of(std::uint64_t bits);

/// Returns the rules for a leaf's shadow pyrays: the levels that their parent left, and EPS
/// relative to the leaf's contribution (ErrorBudget::nested).
[[nodiscard]] SubdivisionRules shadow_rules(const ShadowRules& rules, const ShadowQuery& query);

/// Returns the levels that a leaf leaves to its shadow pyrays, at least 1.
[[nodiscard]] int levels_left(const ShadowRules& rules, const Leaf& leaf);

/// Returns the length of a hit list above which samples cost less than the search.
[[nodiscard]] std::size_t most_entries_for_samples(int levels);

/// Returns whether the surface of a lit point is known over the whole leaf. This is true for the
/// nearest surface, and for a flat one that is visible through others without deflection.
[[nodiscard]] bool has_patch(const ShadowContext& block, const Illumination& lit);

/// Returns the patch on the point's plane that a square of the viewer's frame covers, with the
/// leaf's border in units of that square. Returns nothing if the plane does not cross the frame's
/// rays. The border is valid in the workspace until the next call.
[[nodiscard]] std::optional<ShadowPatch> patch_of(const ShadowContext& block,
                                                  const SurfacePoint& point,
                                                  const LeafRegion& region, const Square& s);

/// Returns the largest deviation of the surface from a patch's plane, up to its corners, in world
/// units.
[[nodiscard]] double deviation(const ShadowContext& block, const SurfacePoint& point,
                               const ShadowPatch& patch);

/// Traces a shadow pyray, whose search may have begun (Tracer::search). Counts its rays and informs
/// observers.
Trace trace_shadow(const ShadowContext& block, const ShadowQuery& query, const Pyray& pyray,
                   const SubdivisionRules& rules, ShadowCaster& caster, RenderStatistics& counts,
                   std::optional<std::span<const BorderEdge>> searched = std::nullopt);

}  // namespace asos
