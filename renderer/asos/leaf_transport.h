#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/shadow_context.h"

namespace asos {

/// The lights and reflections of one leaf: what the shader asks while it shades the leaf's point.
class LeafTransport final : public LightTransport {
 public:
  LeafTransport(const EyeContext& eye, const ShadowContext& shadows, const LeafContext& leaf)
      : eye_(&eye), shadows_(&shadows), leaf_(&leaf) {}

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;
  bool reflect(const Reflection& reflection, glm::vec3& radiance,
               RenderStatistics& counts) override;

  /// Whether a light without a size took more than one ray and was seen in part.
  [[nodiscard]] bool met_shadow_edge() const { return met_shadow_edge_; }
  /// Whether a boundary divided what the leaf mirrors.
  [[nodiscard]] bool met_mirror_edge() const { return met_mirror_edge_; }

 private:
  const EyeContext* eye_;
  const ShadowContext* shadows_;
  const LeafContext* leaf_;
  bool met_shadow_edge_ = false;
  bool met_mirror_edge_ = false;
};

}  // namespace asos
