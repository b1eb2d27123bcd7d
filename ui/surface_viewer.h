#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/samples/surface_view.h"
#include "ui/stoppable_job.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace asos::ui {

class Previewer;

/// The surfaces' properties that are shown in place of the picture or over it.
struct SurfaceChoice {
  std::optional<SurfaceProperty> property;  ///< none: the picture
  bool wireframe = false;                   ///< edges of triangles over either

  [[nodiscard]] bool any() const { return property.has_value() || wireframe; }
};

/// Renders the chosen property of the surfaces in the background: first in coarse squares, then one
/// sample per pixel, then nine. All members are for one thread.
class SurfaceViewer {
 public:
  /// Call once a frame. A change of scene, camera, size, culling or property starts anew; the old
  /// picture stays until the new one is there.
  void update(const Previewer& previewer, const SurfaceChoice& choice);
  /// The latest picture; null while nothing is chosen or nothing is ready.
  [[nodiscard]] const SurfacePicture* picture() const { return picture_.get(); }
  /// Grows with each new picture.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Whether a better picture is on its way.
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  struct Subject {
    std::shared_ptr<const Geometry> geometry;
    std::uint64_t camera_revision = 0;
    glm::ivec2 size{0};
    Culling faces = Culling::none;
    SurfaceProperty property = SurfaceProperty::base_color;
    bool operator==(const Subject&) const = default;
  };

  std::optional<Subject> subject_;  // of the job
  std::shared_ptr<const SurfacePicture> picture_;
  std::uint64_t revision_ = 0;
  StoppableJob<std::shared_ptr<const SurfacePicture>> job_;
};

/// The names of the object and the material at a pixel of the picture, as "object, material"; empty
/// where no surface is.
[[nodiscard]] std::string surface_names(const Previewer& previewer, glm::ivec2 pixel);

}  // namespace asos::ui
