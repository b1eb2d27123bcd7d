#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/frame.h"
#include "renderer/kernels/aim_kernel.h"
#include "renderer/kernels/shading_points.h"
#include "renderer/kernels/sobol_kernel.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace asos {

struct ShadowContext;
struct ShadowQuery;

/// Points from the whole patch of a leaf, in batches for kernels, with their places on a light.
/// They are well distributed over patch and light together (SobolPixel). If the leaf's lobe is
/// broad, they have its material, since such a lobe weights the parts of a light unequally.
class PatchPoints {
 public:
  /// Must be called for each new leaf or light.
  void start(const ShadowContext& block, const ShadowQuery& query);

  /// Returns those of the points `first` to `end` - 1, at most ShadingPoints::size of them, that
  /// lie on the patch.
  const ShadingPoints& look(const ShadowContext& block, const ShadowQuery& query,
                            std::uint32_t first, std::uint32_t end, RenderStatistics& counts);
  /// Returns how rays from the points are weighted.
  [[nodiscard]] RayWeighting aimed_by() const { return by_; }
  /// Returns the points' places on a light.
  const LightPointBatch& on_light(std::uint32_t light);

 private:
  void place(const LeafRegion& region, std::uint32_t first, std::uint32_t end);
  void add(const ShadowQuery& query, const SurfacePoint& at);
  void add_number(std::uint32_t number);

  std::optional<SobolPixel> sobol_;
  RayWeighting by_ = RayWeighting::irradiance;
  ShadingPoints points_;
  SobolBatch numbers_;
  LightPointBatch on_light_;
  SobolPixelSampler on_pixel_;
  std::vector<glm::vec2> places_;  // in the viewer's square
  std::vector<std::uint32_t> number_of_;
  std::vector<SurfacePoint> seen_;
};

}  // namespace asos
