#include "renderer/geometry/box.h"
#include "renderer/world/framing.h"
#include "renderer/world/world.h"
#include "ui/panels/overlays.h"
#include "ui/panels/projection.h"
#include "ui/theme.h"

// The bounding box of a scene that is being loaded.

namespace asos::ui {
namespace {

// Opacity of the cover over the previous picture.
constexpr float cover = 0.8f;

/// The box and its camera, relative to the box's centre.
struct PlacedBox {
  World world;  ///< without surfaces; only its bounds count
  Camera camera;
};

PlacedBox placed(const ScenePreview& preview, double aspect_ratio) {
  const glm::dvec3 middle = 0.5 * (preview.lo + preview.hi);
  PlacedBox box;
  box.world.bounds = {glm::vec3(preview.lo - middle), glm::vec3(preview.hi - middle)};
  if (preview.camera) {
    box.camera = preview.camera->without_planes();
    box.camera.world_from_camera[3] -= glm::dvec4(middle, 0.0);
  } else {
    box.camera = default_camera(box.world, aspect_ratio);
  }
  return box;
}

glm::dvec3 corner_of(const Box& box, unsigned corner) {
  return {corner & 1u ? box.hi.x : box.lo.x, corner & 2u ? box.hi.y : box.lo.y,
          corner & 4u ? box.hi.z : box.lo.z};
}

/// Returns the box to show; null: none.
std::shared_ptr<const ScenePreview> shown_preview(const Previewer& previewer) {
  const OpenScene& scene = previewer.scene();
  const auto loading = scene.loading();
  if (loading && !scene.loads_again())
    return loading->seconds < loading_box_delay ? nullptr : loading->preview;
  return previewer.awaits_first_picture() ? scene.preview() : nullptr;
}

}  // namespace

void loading_box(const Previewer& previewer, const PictureArea& area) {
  const std::shared_ptr<const ScenePreview> preview = shown_preview(previewer);
  if (!preview) return;
  const glm::ivec2 pixels(glm::round(area.rect.size * area.scale));
  if (pixels.x < 1 || pixels.y < 1) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const glm::vec2 end = area.rect.lo + area.rect.size;
  draw.AddRectFilled({area.rect.lo.x, area.rect.lo.y}, {end.x, end.y},
                     theme::packed(theme::ground, cover));
  const PlacedBox box = placed(*preview, static_cast<double>(pixels.x) / pixels.y);
  PictureView whole;
  whole.set_sizes(pixels, pixels);
  const View view(box.camera, pixels.x, pixels.y, radius_around_origin(box.world.bounds));
  const Projection projection(view, pixels, whole, area);
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      if (corner & axis) continue;
      projection.line(draw, corner_of(box.world.bounds, corner),
                      corner_of(box.world.bounds, corner | axis),
                      theme::packed(theme::accent_bright));
    }
  }
}

}  // namespace asos::ui
