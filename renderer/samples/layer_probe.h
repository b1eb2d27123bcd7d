#pragma once

#include "renderer/film/layer_sums.h"
#include "renderer/film/statistics.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/view_context.h"
#include "renderer/shading/shade.h"

#include <optional>

namespace asos {

/// Evaluates the surface layers that the settings ask for where an eye ray meets its nearest
/// surface. Blended surfaces of opacity 0 do not count. In the alpha layer and in the coverage of
/// ids, surfaces count by their opacity, from front to back; in all other layers the first one
/// counts as opaque. Thread-compatible.
class LayerProbe {
 public:
  /// `scene` and `viewer` have to outlive this.
  LayerProbe(const RenderScene& scene, const ViewContext& viewer, const RenderSettings& settings);

  /// `seen`: the ray, its hit, and the square of the picture that the ray represents.
  [[nodiscard]] LayerSample at(const ViewedRay& seen, RenderStatistics& counts) const;

 private:
  void add_surface(const ViewedRay& seen, LayerSample& sample) const;

  const RenderScene* scene_;
  const ViewContext* viewer_;
  LayerSet layers_;
  bool points_;     // some layer needs the point of the surface
  bool materials_;  // or its material
  const MipChains* mips_;
  std::optional<Shader> coverage_;  // where surfaces may be blended
};

}  // namespace asos
