#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/surface.h"
#include "renderer/shadows/shadow_caster.h"
#include "renderer/shadows/shaft.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// The known visibility between some points and a light.
struct KnownVisibility {
  enum class Passage : std::uint8_t { open, lit, shaded };

  Passage passage = Passage::open;  ///< for all points and the whole light
  const FeatureCut* cut = nullptr;  ///< open: where boundaries may be; null: anywhere
};

/// The surfaces visible in a block of pixels, one group for each smooth surface, with the feature
/// cut between each and the lights. A cut is computed once and passed to all shadow pyrays that
/// start there. Nodes are shared, but not edges: all points of the block together see many more
/// silhouettes than any one of them (design section 12).
class ShadowGroups {
 public:
  explicit ShadowGroups(const ShadowScene& scene);

  /// Starts a block.
  void reset(std::size_t lights);
  /// Adds a visible point of the block with the patch of its pixel; `lift` is that of SurfacePoint.
  void add(const Hit& hit, glm::vec3 position, glm::vec3 normal, const Patch& patch,
           glm::vec3 lift = glm::vec3(0.0f));

  /// Returns the known visibility between a patch around `point` and a light. Adds the rays cast
  /// for it to `rays_cast`. The cut is valid until the next call of `reset`.
  [[nodiscard]] KnownVisibility ask(const PreparedLight& light, std::uint32_t index,
                                    const SurfacePoint& point, const Box& patch,
                                    std::uint64_t& rays_cast);

 private:
  struct Answer {
    bool known = false;
    KnownVisibility::Passage passage = KnownVisibility::Passage::open;
    ShaftSearch search;
  };
  struct Group {
    std::uint32_t smooth_surface = 0;
    Box box;
    HalfSpace plane;  // of the first point
    bool planar = true;
    double tolerance = 0;  // largest distance of points from the plane by rounding
    std::vector<Answer> answers;
    std::optional<bool> stood_upon;  // computed at first use
  };

  [[nodiscard]] Group* group_of(const SurfacePoint& point, const Box& patch);
  void find(const PreparedLight& light, const SurfacePoint& point, Group& group, Answer& answer,
            std::uint64_t& rays_cast);
  [[nodiscard]] bool stood_upon(Group& group) const;
  [[nodiscard]] bool nothing_between(const PreparedLight& light, const Shaft& shaft) const;
  [[nodiscard]] bool rises_above(const PreparedLight& light, const Group& group) const;
  [[nodiscard]] Box light_box(const PreparedLight& light, const Box& from) const;

  const ShadowScene& scene_;
  double reach_;
  std::size_t lights_ = 0;
  std::vector<Group> groups_;
  std::size_t used_ = 0;
};

/// Returns a distance larger than any in the world, at which light from infinity starts.
[[nodiscard]] double world_reach(const World& world);

/// Returns bounds that ignore the vertices of the light's own surface, which does not shade it.
[[nodiscard]] SearchBounds own_part_ignored(const World& world, const PreparedLight& light);

}  // namespace asos
