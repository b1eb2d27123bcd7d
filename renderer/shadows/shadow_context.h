#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/rules.h"
#include "renderer/pyray/tracer.h"
#include "renderer/settings/settings.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/leaf_context.h"
#include "renderer/shadows/lit_patch.h"
#include "renderer/shadows/patch_caster.h"
#include "renderer/shadows/patch_view.h"
#include "renderer/shadows/sampled_rays.h"
#include "renderer/shadows/shadow_groups.h"
#include "renderer/shadows/window_caster.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace asos {

class AreaShadows;

/// The rules that shadows of a viewer's leaves go by.
struct ShadowRules {
  /// Replaces shadows of lights of some size; null: as exact as the allowance asks.
  const AreaShadows* area_shadows = nullptr;
  Allowance allowance;  ///< of the viewer's pyrays; those of shadows get what its levels leave
  const SubdivisionVariant* variant = nullptr;  ///< of shadow pyrays; null: the engine's own way
  /// Some surfaces of the scene let more light through here than there, or have holes, without
  /// boundaries that tell where (FeatureSet::opacity_unbounded).
  bool see_through = true;
};

/// Memory of shadow pyrays that is worth keeping. Holds no result.
struct ShadowWorkspace {
  Tracer tracer;
  WindowCaster window_caster;
  PatchCaster patch_caster;
  std::vector<BorderEdge> border;
  std::vector<double> ends;
  LitPatch patch;
  SampledRays sampled;
};

/// The surroundings that the shadows of one viewer's block share. Keeps pointers.
struct ShadowContext {
  const ShadowScene* scene = nullptr;
  ShadowRules rules;
  std::size_t lights = 1;        ///< in the scene
  const Frame* frame = nullptr;  ///< of the viewer's block
  PatchView* view = nullptr;
  ShadowGroups* groups = nullptr;
  ShadowWorkspace* work = nullptr;
};

/// The question to a shadow: how much of a light reaches the leaf's point?
struct ShadowQuery {
  const Illumination& lit;
  const LeafContext& leaf;
  SearchBounds found;  ///< where boundaries between the leaf and the light may be

  /// The light's full contribution in display units, at most 1.
  [[nodiscard]] double intensity() const;
};

/// The receiver of a light: clear of the surface, and of a light that is infinitely far on the way
/// to its middle, so that shadows stay in their place.
[[nodiscard]] Receiver receiver_above(const SurfacePoint& point, const PreparedLight& light);

/// Two numbers in [0, 1).
[[nodiscard]] glm::dvec2 unit_pair_of(std::uint64_t bits);

/// The rules of a leaf's shadow pyrays: the levels that its parent left and EPS of what it
/// contributes (Allowance::nested).
[[nodiscard]] SubdivisionRules shadow_rules(const ShadowRules& rules, const ShadowQuery& query);

/// The levels that a leaf leaves to its shadow pyrays, 1 at least.
[[nodiscard]] int levels_left(const ShadowRules& rules, const LeafContext& leaf);

/// The largest hit list before samples cost less than the search.
[[nodiscard]] std::size_t most_entries_for_samples(int levels);

/// Whether all that a leaf shows of a lit point's surface is known: that of the nearest surface,
/// and of a flat one that is seen straight through others.
[[nodiscard]] bool has_patch(const ShadowContext& block, const Illumination& lit);

/// The patch on the point's plane that a square of the viewer's frame shows, with the border of the
/// leaf in units of that square. Nothing where the plane does not cross the frame's rays. The
/// border lives in the workspace until the next call.
[[nodiscard]] std::optional<ShadowPatch> patch_of(const ShadowContext& block,
                                                  const SurfacePoint& point,
                                                  const LeafRegion& region, const Square& s);

/// How far the surface may leave a patch's plane, up to its corners, in world units.
[[nodiscard]] double deviation(const ShadowContext& block, const SurfacePoint& point,
                               const ShadowPatch& patch);

/// Traces a shadow pyray whose search has begun (Tracer::search) or begins now, counts its rays and
/// tells observers.
Trace trace_shadow(const ShadowContext& block, const ShadowQuery& query, const Pyray& pyray,
                   const SubdivisionRules& rules, ShadowCaster& caster, RenderStatistics& counts,
                   std::optional<std::span<const BorderEdge>> searched = std::nullopt);

}  // namespace asos
