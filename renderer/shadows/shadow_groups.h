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

/// The passage of light between some points and a light, as far as it is known.
struct ShadowKnowledge {
  enum class Passage : std::uint8_t { open, lit, shaded };

  Passage passage = Passage::open;  ///< for all of the points and all of the light
  const FeatureCut* cut = nullptr;  ///< open: where boundaries may be; null: anywhere
};

/// The surfaces that a block of pixels shows, one group for each smooth piece, with what lies
/// between each and the lights: found once and handed to all shadow pyrays that start there. Nodes
/// are shared, not edges: the silhouettes that the block's points see together are many more than
/// any one of them sees (design section 12).
class ShadowGroups {
 public:
  explicit ShadowGroups(const ShadowScene& scene);

  /// Starts a block, whose pixels are seen to show these patches around these hits.
  void reset(std::size_t lights);
  /// A point that the block shows, and the patch of its pixel; `lift`: SurfacePoint's.
  void add(const Hit& hit, glm::vec3 position, glm::vec3 normal, const Patch& patch,
           glm::vec3 lift = glm::vec3(0.0f));

  /// The passage from a patch around `point` to a light, as far as it is known. Rays cast to find
  /// out are added to `rays_cast`. The cut lives until the next call of `reset`.
  [[nodiscard]] ShadowKnowledge ask(const PreparedLight& light, std::uint32_t index,
                                    const SurfacePoint& point, const Box& patch,
                                    std::uint64_t& rays_cast);

 private:
  struct Answer {
    bool known = false;
    ShadowKnowledge::Passage passage = ShadowKnowledge::Passage::open;
    ShaftSearch search;
  };
  struct Group {
    std::uint32_t sheet = 0;
    Box box;
    HalfSpace plane;  // of the first point
    bool planar = true;
    double tolerance = 0;  // how far from the plane points may lie by rounding
    std::vector<Answer> answers;
    std::optional<bool> stood_upon;  // once it is asked
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

/// Farther than anything in the world is from anything else: where light from infinitely far
/// starts.
[[nodiscard]] double world_reach(const World& world);

/// Vertices of the light's own surface, which does not shade it.
[[nodiscard]] SearchBounds own_part_ignored(const World& world, const PreparedLight& light);

}  // namespace asos
