#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/result.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos {

/// Opacity of `triangle` at (b1, b2), 0 to 1, for a ray's alpha test.
using AlphaAt = float (*)(const World& world, std::uint32_t triangle, float b1, float b2);

/// What a blended surface makes of light that goes straight through it, by colour.
struct StraightPassage {
  glm::vec3 share{1.0f};       ///< that goes on
  glm::vec3 extinction{0.0f};  ///< of the volume that it bounds: share exp(-extinction) a length
  bool enters = false;         ///< the light goes into that volume, and not out of it
};
/// That of light along `direction`, of any length, where `hit` is. A hit's `t` counts for nothing.
using PassageAt = StraightPassage (*)(const World& world, const Hit& hit, glm::vec3 direction);

/// The sides of surfaces that a ray does not meet.
enum class Culling : std::uint8_t {
  none,  ///< both sides are met
  /// A ray goes through the back of a single-sided material's triangle as if it were not there, as
  /// glTF 2.0 says for what a viewer sees (section 3.9.4, doubleSided; which side is the back:
  /// meets_back).
  as_material_says,
};

/// What the rays' hierarchy is built for.
enum class HierarchyUse : std::uint8_t {
  lasting,  ///< many rays: the one that is traced fastest
  moment,   ///< one moment of what moves: built in a fifth of the time where it can be, and traced
            ///< a tenth slower at most
};

/// Rays as arrays, which start where they are: the arrays may be read up to the next multiple
/// of 16.
struct RayArrays {
  std::size_t count = 0;
  std::array<const float*, 3> origin{};
  std::array<const float*, 3> direction{};  ///< unit
  const float* t_far = nullptr;
};

/// The surfaces that a shadow ray meets on its way.
struct Blocker {
  /// The nearest surface that blocks all light: opaque, or masked where its opacity reaches the
  /// cut-off; not valid if there is none.
  Hit hit;
  /// The same as `RayScene::transmittance`: 0 if blocked, else the share that blended surfaces, and
  /// volumes, leave.
  glm::vec3 transmittance{1.0f};
  /// Whether the ray met the geometry of a masked or blended material no farther than `hit` (which
  /// may be masked itself), hole or not: rays nearby may then fare otherwise, although no outline
  /// of a surface lies between. Masked surfaces whose cut-outs' outlines are known do not count.
  bool see_through = false;
  /// The same of masked materials alone.
  bool cut_out = false;
};

/// Rays against a world's triangles and analytic shapes, through Embree. Masked surfaces are tested
/// against their cut-off; blended ones are met by `closest` and attenuate `transmittance`. Shadow
/// rays meet both sides of every surface, and so do others unless they ask for less. Keeps a
/// pointer into the world, which must stay where it is and outlive it. Thread-safe once built.
///
/// Queries for shadows take the part (index into World::parts) that shines the light in question
/// and does not shade it: `Light::own_part` of a light that it was built with, or -1 for none. A
/// part that is no light's own is never ignored. No such query meets lines and points.
///
/// The same call gives the same bits on one machine. A query for one ray, and spans cut
/// differently, may differ in a hit's last bits, so what goes into one span must not depend on the
/// timing of threads. A ray that is not finite, or has no direction, meets nothing; so does every
/// ray on a RayScene that was not built.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Errors: Embree's, such as lack of memory, and a light whose own part does not exist. `lights`:
  /// those whose own parts queries may ignore. `forced`: tests that are made although no surface
  /// asks for them; they change no answer. `passage`: of blended surfaces; null: they let the same
  /// share of all colours through, by their opacity. `use` changes no answer but, where surfaces
  /// meet, which of them is hit.
  [[nodiscard]] static Result<RayScene> build(const World& world, AlphaAt alpha,
                                              std::span<const Light> lights = {},
                                              const SceneNeeds& forced = {},
                                              PassageAt passage = nullptr,
                                              HierarchyUse use = HierarchyUse::lasting);

  /// The nearest hit of each ray; `hits` is as long as `rays`. Coherent rays go in packets. Where
  /// triangles of different parts lie in one plane, it is the one in front: blended and cut-out
  /// ones before opaque ones, and of the same kind the later primitive of the file.
  void closest(std::span<const Ray> rays, std::span<Hit> hits, Culling faces = Culling::none) const;
  [[nodiscard]] Hit closest(const Ray& ray, Culling faces = Culling::none) const;

  /// Whether a hit's triangle lies in one plane with one of another part, and overlaps it.
  [[nodiscard]] bool is_coplanar(const Hit& hit) const;
  /// All that a ray meets in the place of such a hit, from front to back, and the hit itself.
  void in_place(const Ray& ray, const Hit& hit, Culling faces, std::vector<Hit>& met) const;

  /// The share of light that passes straight along each ray, 0 (blocked) to 1 by colour; `shares`
  /// is as long as `rays`. No more than 2^-16 counts as nothing where blended surfaces leave it.
  /// In a volume it is what is left after the way between its boundaries; a ray that starts inside
  /// has come from there, one that ends inside goes on to its end.
  void transmittance(std::span<const Ray> rays, std::span<glm::vec3> shares,
                     std::int32_t ignored_part = -1) const;
  void transmittance(const RayArrays& rays, std::span<glm::vec3> shares,
                     std::int32_t ignored_part = -1) const;
  [[nodiscard]] glm::vec3 transmittance(const Ray& ray, std::int32_t ignored_part = -1) const;

  /// The surfaces that each ray meets on its way to a light; `blockers` is as long as `rays`.
  /// `outlined`, by surface: 1 where its cut-outs' outlines are known (FeatureSet::outlined);
  /// empty: nowhere.
  void blockers(std::span<const Ray> rays, std::span<Blocker> blockers,
                std::int32_t ignored_part = -1, std::span<const std::uint8_t> outlined = {}) const;

  /// The memory that Embree holds for this scene, and the copies made for it.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Rays traced at once by the queries for spans: 16, 8, 4 or 1. Chosen for the processor by
  /// `build`; another width, of those that it has, may be set for a measurement, while no ray is
  /// under way.
  [[nodiscard]] int packet_width() const;
  void set_packet_width(int width);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos
