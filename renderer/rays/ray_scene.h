#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/result.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos {

namespace tracing {
struct Transparency;
}

/// Returns the opacity of `triangle` at (b1, b2), 0 to 1, for a ray's alpha test.
using AlphaAt = float (*)(const World& world, std::uint32_t triangle, float b1, float b2);

/// Transmittance of a blended surface without deflection, by colour.
struct StraightTransmission {
  glm::vec3 share{1.0f};  ///< fraction that passes
  /// Extinction of the volume that it bounds: a fraction of exp(-extinction) is left per length.
  glm::vec3 extinction{0.0f};
  bool enters = false;  ///< the light enters that volume, instead of leaving it
};
/// Returns the passage of light along `direction`, of any length, at `hit`. The hit's `t` is not
/// used.
using TransmissionAt = StraightTransmission (*)(const World& world, const Hit& hit,
                                                glm::vec3 direction);

/// The sides of surfaces that rays ignore.
enum class Culling : std::uint8_t {
  none,  ///< both sides are hit
  /// Rays pass through the backs of single-sided materials, as glTF 2.0 specifies for the viewer
  /// (section 3.9.4, doubleSided; meets_back defines the back).
  as_material_says,
};

/// The purpose of the rays' hierarchy.
enum class BvhPurpose : std::uint8_t {
  lasting,  ///< many rays: the hierarchy with the fastest traversal
  moment,   ///< one moment of an animation: built in a fifth of the time where possible, and
            ///< at most a tenth slower to trace
};

/// Rays as arrays, read in place: up to the next multiple of 16 numbers may be read.
struct RayArrays {
  std::size_t count = 0;
  std::array<const float*, 3> origin{};
  std::array<const float*, 3> direction{};  ///< unit
  const float* t_far = nullptr;
};

/// The surfaces along a shadow ray.
struct Blocker {
  /// The nearest surface that blocks all light: opaque, or masked where its opacity reaches the
  /// cut-off; not valid if there is none.
  Hit hit;
  /// As `RayScene::transmittance`: 0 if blocked, else the fraction that blended surfaces and
  /// volumes leave.
  glm::vec3 transmittance{1.0f};
  /// Whether the ray met a masked or blended surface no farther than `hit` (which may be masked
  /// itself), even at a hole. Then nearby rays may have another result without a surface outline in
  /// between. Masked surfaces with known cut-out outlines do not count.
  bool see_through = false;
  /// See-through by masked materials.
  bool cut_out = false;
};

/// Traces rays against a world's triangles and analytic shapes with Embree. Masked surfaces are
/// tested against their cut-off. Blended ones are hit by `closest` and attenuate `transmittance`.
/// Shadow rays hit both sides of every surface, and so do others by default. Stores a pointer to
/// the world, which must not be moved and must outlive it. Thread-safe once built.
///
/// Shadow queries take the own part of the light (index into World::parts), which does not shade
/// it: `Light::own_part` of a light given to `build`, or -1 for none. A part that is no light's own
/// is never ignored. Shadow queries ignore lines and points.
///
/// The same call gives the same bits on one machine. A query for one ray, and differently divided
/// spans, may differ in a hit's last bits. The contents of a span therefore must not depend on the
/// timing of threads. A ray that is not finite, or has no direction, hits nothing; so does every
/// ray on a RayScene that was not built.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Builds the scene. Errors: Embree's, such as lack of memory, and a light whose own part does
  /// not exist.
  /// - `lights`: their own parts can be ignored by queries.
  /// - `forced`: tests that are made even if no surface needs them; they change no result.
  /// - `passage`: for blended surfaces; null: they transmit all colours equally, by their opacity.
  /// - `use`: changes no result, except which of several touching surfaces is hit.
  /// - `known`: the scene of a world with some of the same surfaces (Part::surfaces), which shares
  ///   what depends on these; null: none. It changes no result.
  [[nodiscard]] static Result<RayScene> build(const World& world, AlphaAt alpha,
                                              std::span<const Light> lights = {},
                                              const RenderFeatures& forced = {},
                                              TransmissionAt passage = nullptr,
                                              BvhPurpose use = BvhPurpose::lasting,
                                              const RayScene* known = nullptr);

  /// The largest number of poses in a motion.
  static constexpr std::size_t most_poses = 129;
  /// Builds the scene of a motion through `poses`: worlds at even times from 0 to 1, at most
  /// most_poses. In between, vertices, faces and places of meshes move linearly. What does not move
  /// is stored once. All poses have the same triangles, faces and placed meshes, and the same kinds
  /// of surfaces; they must outlive the scene. Queries without times see the first pose. Arguments
  /// and errors: as for `build`.
  [[nodiscard]] static Result<RayScene> build_moving(std::span<const World* const> poses,
                                                     AlphaAt alpha,
                                                     std::span<const Light> lights = {},
                                                     const RenderFeatures& forced = {},
                                                     TransmissionAt passage = nullptr,
                                                     BvhPurpose use = BvhPurpose::lasting);

  /// Finds the nearest hit of each ray; `hits` is as long as `rays`. Coherent rays go in packets.
  /// If triangles of different parts are coplanar, it is the one in front: blended and cut-out ones
  /// before opaque ones, and of the same kind the later primitive of the file.
  void closest(std::span<const Ray> rays, std::span<Hit> hits, Culling faces = Culling::none) const;
  [[nodiscard]] Hit closest(const Ray& ray, Culling faces = Culling::none) const;
  /// Does so at the rays' times, 0 to 1, in the scene of a motion. `times` is as long as `rays`.
  /// Holes, backs and coplanar surfaces are those of `pose`, one of the motion's poses.
  void closest(std::span<const Ray> rays, std::span<const float> times, const World& pose,
               std::span<Hit> hits, Culling faces = Culling::none) const;

  /// Returns whether a hit's triangle is coplanar with one of another part, and overlaps it.
  [[nodiscard]] bool is_coplanar(const Hit& hit) const;
  /// Finds all surfaces at the place of a coplanar hit, from front to back, including the hit
  /// itself.
  void in_place(const Ray& ray, const Hit& hit, Culling faces, std::vector<Hit>& met) const;

  /// Computes the fraction of light that passes straight along each ray, 0 (blocked) to 1 by
  /// colour; `shares` is as long as `rays`. If blended surfaces leave at most 2^-16, the result is
  /// 0. In a volume it is the fraction left after the distance between its boundaries. A ray that
  /// starts inside is attenuated from its start, and one that ends inside up to its end.
  void transmittance(std::span<const Ray> rays, std::span<glm::vec3> shares,
                     std::int32_t ignored_part = -1) const;
  void transmittance(const RayArrays& rays, std::span<glm::vec3> shares,
                     std::int32_t ignored_part = -1) const;
  [[nodiscard]] glm::vec3 transmittance(const Ray& ray, std::int32_t ignored_part = -1) const;

  /// Finds the surfaces along each ray to a light; `blockers` is as long as `rays`. `outlined`, by
  /// surface: 1 if the outlines of its cut-outs are known (FeatureSet::outlined); empty: none are.
  void blockers(std::span<const Ray> rays, std::span<Blocker> blockers,
                std::int32_t ignored_part = -1, std::span<const std::uint8_t> outlined = {}) const;

  /// Returns the memory of Embree for this scene, and of the copies made for it.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Returns the number of rays per packet in queries for spans: 16, 8, 4 or 1. `build` selects it
  /// for the processor. Another supported width may be set for a measurement while no query is
  /// running.
  [[nodiscard]] int packet_width() const;
  void set_packet_width(int width);

 private:
  struct Impl;
  [[nodiscard]] static Result<RayScene> build_from(std::span<const World* const> poses,
                                                   const tracing::Transparency& open,
                                                   std::span<const Light> lights,
                                                   const RenderFeatures& forced, BvhPurpose use,
                                                   const RayScene* known);

  std::unique_ptr<Impl> impl_;
};

}  // namespace asos
