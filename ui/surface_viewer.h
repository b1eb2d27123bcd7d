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

/// Surface properties that are shown instead of the picture or over it.
struct SurfaceChoice {
  std::optional<SurfaceProperty> property;  ///< none: the picture
  bool wireframe = false;  ///< edges of triangles, over the picture or the property

  [[nodiscard]] bool any() const { return property.has_value() || wireframe; }
};

/// Renders the chosen surface property in the background: first in coarse squares, then with one
/// sample per pixel, then nine. All members must be called from one thread.
class SurfaceViewer {
 public:
  /// Call once a frame. A change of scene, camera, size, culling or property restarts; the old
  /// picture stays until the new one is ready.
  void update(const Previewer& previewer, const SurfaceChoice& choice);
  /// The latest picture; null: no property is chosen, or none is ready.
  [[nodiscard]] const SurfacePicture* picture() const { return picture_.get(); }
  /// Grows with each new picture.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Whether a better picture is being rendered.
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

/// The names of the object and the material at a pixel; empty: no surface.
struct SurfaceNames {
  std::string object;
  std::string material;

  [[nodiscard]] std::string joined() const {
    return object.empty() ? std::string() : object + ", " + material;
  }
};
[[nodiscard]] SurfaceNames surface_names(const Previewer& previewer, glm::ivec2 pixel);

}  // namespace asos::ui
