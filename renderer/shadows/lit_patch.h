#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/frame.h"
#include "renderer/kernels/aim_kernel.h"
#include "renderer/kernels/lit_batch.h"
#include "renderer/kernels/sobol_kernel.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace asos {

struct ShadowContext;
struct ShadowQuery;

/// Points from all over the patch that a leaf shows, as kernels take them, and where on a light
/// each of them looks: well distributed on both together (SobolPixel). They have the leaf's
/// material where its lobe is a broad one, which makes more of some parts of a light than of
/// others.
class LitPatch {
 public:
  /// Before another leaf or light is asked about.
  void start(const ShadowContext& block, const ShadowQuery& query);

  /// Those of the points number `first` to `end` - 1, up to LitBatch::size of them, that lie on the
  /// patch.
  const LitBatch& look(const ShadowContext& block, const ShadowQuery& query, std::uint32_t first,
                       std::uint32_t end, RenderStatistics& counts);
  /// What rays from the points are weighed by.
  [[nodiscard]] AimedBy aimed_by() const { return by_; }
  /// Where those look.
  const LightPlaceBatch& on_light(std::uint32_t light);

 private:
  void place(const LeafRegion& region, std::uint32_t first, std::uint32_t end);
  void add(const ShadowQuery& query, const SurfacePoint& at);
  void add_number(std::uint32_t number);

  std::optional<SobolPixel> sobol_;
  AimedBy by_ = AimedBy::irradiance;
  LitBatch points_;
  SobolBatch numbers_;
  LightPlaceBatch on_light_;
  SobolPixelPlaces on_pixel_;
  std::vector<glm::vec2> places_;  // in the viewer's square
  std::vector<std::uint32_t> number_of_;
  std::vector<SurfacePoint> seen_;
};

}  // namespace asos
