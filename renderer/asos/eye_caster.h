#pragma once

#include "renderer/asos/bumps.h"
#include "renderer/asos/counted_lights.h"
#include "renderer/asos/reflected_pyrays.h"
#include "renderer/film/statistics.h"
#include "renderer/geometry/view.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/viewer.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/subdivision_trace.h"
#include "renderer/reflections/mirrored_mask.h"
#include "renderer/samples/region_sampler.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/shade.h"
#include "renderer/shadows/shadow_pyrays.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <stop_token>
#include <vector>

namespace asos {

/// Memory of shadow and reflection pyrays that is worth keeping. Holds no result.
struct EyeWorkspace {
  ShadowWorkspace shadows;
  ReflectionWorkspace reflections;
};

/// Looks along a viewer's rays through one square block of the picture, whose frame's (u, v) runs
/// from 0 to 1 across it: the engine's Caster for eye pyrays, and for those that were mirrored.
/// Leaves are shaded and added up, root by root; a root is a pixel.
class EyeCaster final : public Caster, private PatchView, private LightTransport {
 public:
  /// All have to outlive this. `mask`: what the leaves count for; null: their area.
  EyeCaster(const RenderScene& scene, const Viewer& viewer, const RenderSettings& settings,
            const Frame& frame, PixelRect block, std::size_t roots, EyeWorkspace& work,
            const std::stop_token& stop, RenderStatistics& counts,
            const MirroredMask* mask = nullptr);

  [[nodiscard]] SampleId probe(std::span<const glm::vec2> points) override;
  [[nodiscard]] Cover cover(SampleId sample) const override;
  [[nodiscard]] std::uint32_t surface(SampleId sample) const override;
  [[nodiscard]] Unevenness uneven(SampleId sample, double share,
                                  const LeafRegion& region) const override;
  [[nodiscard]] bool cancelled() const override { return stop_.stop_requested(); }
  void leaf(std::uint32_t root, SampleId sample, double weight, const LeafRegion& region) override;

  [[nodiscard]] TakenOver sample_tangle(std::uint32_t root, const Square& square,
                                        double weight) override;

  /// Learns what surfaces the block shows from the first samples, which are those of the middles of
  /// `side` x `side` pixels in rows: shadow pyrays share what lies between each and the lights, and
  /// neighbours tell how bumpy it is.
  void gather_surfaces(int side);

  /// Whether a sample met the background or a surface without holes and nothing shining through.
  [[nodiscard]] bool opaque(SampleId sample) const;

  /// The world's triangle that a sample met; Hit::none: the background.
  [[nodiscard]] std::uint32_t triangle(SampleId sample) const { return hits_[sample].triangle; }
  /// Keeps the leaves of one root from now on.
  void log_leaves(std::uint32_t root) { logged_root_ = root; }
  [[nodiscard]] const std::vector<TracedLeaf>& logged_leaves() const { return logged_leaves_; }
  /// What one of them sees, linear.
  [[nodiscard]] glm::vec3 logged_radiance(SampleId sample) const {
    const auto found = logged_radiance_.find(sample);
    return found != logged_radiance_.end() ? found->second : glm::vec3(0.0f);
  }

  /// Whether the edge of a hard shadow cut one of a root's leaves.
  [[nodiscard]] bool shadow_cut(std::uint32_t root) const { return sums_[root].shadow_cut; }
  /// Whether a boundary split what one of a root's leaves mirrors.
  [[nodiscard]] bool mirror_cut(std::uint32_t root) const { return sums_[root].mirror_cut; }

  /// Rays of all kinds that were cast for a root's leaves, beside the leaves' own.
  [[nodiscard]] std::uint64_t rays_of_leaves(std::uint32_t root) const { return sums_[root].rays; }

  /// A root's colour: the mean of its leaves. Samples that were not finite were left out and
  /// counted.
  [[nodiscard]] glm::vec3 colour(std::uint32_t root) const;

 private:
  /// A leaf of a blurred reflection, which counts by a kernel that all of them tell together.
  struct BlurredLeaf {
    Square square;
    std::size_t first_side = 0;
    std::size_t side_count = 0;
    double share = 1.0;  ///< of its region that counts
    glm::dvec3 radiance{0.0};
  };
  struct Sum {
    glm::dvec3 radiance{0.0};
    double weight = 0.0;
    bool shadow_cut = false;
    bool mirror_cut = false;
    std::uint64_t rays = 0;
  };

  [[nodiscard]] glm::vec3 shade(SampleId sample, double weight, const LeafRegion& region,
                                RenderStatistics& counts);
  [[nodiscard]] Patch patch_of(SampleId sample, double share) const;
  [[nodiscard]] float bump_error(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] float shading_error(SampleId sample, double share, const LeafRegion& region) const;
  [[nodiscard]] bool glints(SampleId sample, double share) const;
  [[nodiscard]] bool uneven_at_last(SampleId sample, double share, const LeafRegion& region) const;
  void finish_leaf(std::uint32_t root, SampleId sample, double weight, const LeafRegion& region);
  std::uint32_t add_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                            double weight, std::uint32_t fewest);
  glm::vec3 add_leaf(std::uint32_t root, SampleId sample, double weight, const LeafRegion& region);
  bool add_texture_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                           double weight);
  void log_leaf(SampleId sample, double weight, glm::vec3 radiance);
  void add_blurred(const LeafRegion& region, double share, glm::dvec3 radiance, float distance);
  [[nodiscard]] glm::vec3 blurred_colour() const;
  [[nodiscard]] Patch patch_around(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] float light_error(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] bool shadow_uneven(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] bool nearly_flat(SampleId sample, double share) const;
  [[nodiscard]] bool mirrors_too_widely(SampleId sample, const LeafRegion& region) const;
  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;
  bool reflect(const Reflection& reflection, glm::vec3& radiance,
               RenderStatistics& counts) override;
  [[nodiscard]] EvenPatch even_patch(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] EvenPatch* even_around(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] float side_of(double weight) const;
  [[nodiscard]] Ray ray_through(glm::vec2 p) const;
  void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
            RenderStatistics& counts) const override;

  const RenderScene& scene_;
  ShadowScene shadow_scene_;
  Viewer viewer_;
  const Frame& frame_;
  PixelRect block_;
  std::stop_token stop_;
  RenderStatistics& counts_;
  const Shader& shader_;
  const PixelSpacing& spacing_ = viewer_.spacing;
  const MirroredMask* mask_;
  Faces faces_;
  float most_uneven_;
  ShadowGroups groups_;
  mutable ShadowPyrays shadows_;
  EyeWorkspace& work_;
  MirroredLeaf leaf_;  // that is being shaded
  bool met_mirror_edge_ = false;
  CountedLights counted_shadows_{shadows_};
  bool cast_shadows_ = false;     // some light does
  bool extended_lights_ = false;  // and has a size
  bool spots_ = false;
  std::vector<glm::vec2> points_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<Sum> sums_;
  const RenderSettings& settings_;
  std::vector<BlurredLeaf> blurred_;
  std::vector<Side> blurred_sides_;
  float nearest_blurred_ = std::numeric_limits<float>::infinity();
  std::optional<RegionSampler> sampler_;  // made when first needed
  mutable std::vector<EvenPatch> even_;
  EvenPatch* divided_ = nullptr;  // the leaf whose parts are being shaded
  Bumps bumps_;
  int border_ = 0;  // pixels of the frame around the block
  mutable std::vector<Ray> looked_rays_;
  mutable std::vector<Hit> looked_hits_;
  std::uint32_t logged_root_ = no_sample;
  std::vector<TracedLeaf> logged_leaves_;
  std::map<SampleId, glm::vec3> logged_radiance_;
};

}  // namespace asos
