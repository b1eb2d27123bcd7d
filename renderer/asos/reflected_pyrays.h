#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/prepared/viewer.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/subdivide.h"
#include "renderer/reflections/mirror_surface.h"
#include "renderer/reflections/mirrored_mask.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace asos {

struct EyeWorkspace;
class EyeCaster;

/// The leaf of a parent pyray that is being shaded.
struct MirroredLeaf {
  LeafRegion region;       ///< of the parent's frame
  double weight = 1.0;     ///< its share of its root's area
  std::uint64_t seed = 0;  ///< of its own
  glm::vec2 at{0.5f};      ///< its sample
};

/// What a leaf sends to the viewer by way of a mirror.
struct Mirrored {
  glm::vec3 radiance{0.0f};
  bool split = false;    ///< a boundary divided it
  bool followed = true;  ///< false: the pyray that would show it has no extent or is not finite
};

/// Memory of reflected pyrays by how many bounces lie before them. Holds no result.
class ReflectionWorkspace {
 public:
  struct Bounce {
    HitLists lists;
    HitLists::List list;
    Subdivider subdivider;
    RenderSettings settings;
  };
  [[nodiscard]] Bounce& at(int bounce);

 private:
  std::vector<std::unique_ptr<Bounce>> bounces_;
};

/// A mirrored pyray, and the mirror where its axis meets it.
struct MirroredSight {
  MirroredPyray pyray;
  MirrorSurface surface;
};

/// Reflected pyrays of one viewer's leaves (CGF'98 section 5): the same engine, in the frame that
/// the surface mirrors.
struct ReflectedPyrays {
  const RenderScene& scene;
  const Viewer& viewer;
  const RenderSettings& settings;
  const Frame& frame;  ///< of the viewer's block
  PixelRect block;     ///< in the viewer's picture
  EyeWorkspace& work;
  const std::stop_token& stop;

  [[nodiscard]] Mirrored trace(const Reflection& reflection, const MirroredLeaf& leaf,
                               RenderStatistics& counts) const;

 private:
  [[nodiscard]] Mirrored trace(const Reflection& reflection, const MirroredLeaf& leaf, float width,
                               RenderStatistics& counts) const;
  [[nodiscard]] IncidentPyray pyray_of(const Reflection& reflection, const Bounds2& part) const;
  [[nodiscard]] glm::dvec3 start_of(const Bounds2& part) const;
  [[nodiscard]] std::optional<MirroredSight> sight_of(const Reflection& reflection,
                                                      const Bounds2& part, float width) const;
  [[nodiscard]] double brightest_in(const PyrayPicture& picture) const;
  [[nodiscard]] ReflectionWorkspace::Bounce& level_of(const Reflection& reflection,
                                                      const MirroredLeaf& leaf,
                                                      double brightest) const;
  bool subdivide(ReflectionWorkspace::Bounce& level, const Root& root, EyeCaster& caster) const;
  void find_boundaries(ReflectionWorkspace::Bounce& level, const Frame& mirrored_frame,
                       const MirroredSight& sight, const MirroredMask& mask) const;
};

}  // namespace asos
