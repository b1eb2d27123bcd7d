#include "ui/surface_viewer.h"

#include "renderer/files/printable.h"
#include "ui/previewer.h"

#include <fmt/format.h>

#include <array>

namespace asos::ui {

namespace {

constexpr std::array passes{SurfaceSampling{4, 1}, SurfaceSampling{1, 1}, SurfaceSampling{1, 3}};

std::string name_or_number(const std::string& name, const char* kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : printable(name);
}

}  // namespace

void SurfaceViewer::update(const Previewer& previewer, const SurfaceChoice& choice) {
  const OpenScene& scene = previewer.scene();
  if (!choice.any() || !scene || !previewer.viewpoint().sized()) {
    job_.stop();
    subject_.reset();
    picture_.reset();
    return;
  }
  if (job_.stopping() && !job_.busy()) subject_.reset();
  const RenderSettings& settings = previewer.edits().settings();
  const Subject wanted{scene->geometry,
                       previewer.viewpoint().camera().revision(),
                       {settings.width, settings.height},
                       culling_of(settings),
                       choice.property.value_or(SurfaceProperty::base_color)};
  // While the view changes in every frame, an outdated coarse picture is better than none.
  if (auto outcome = job_.take_outcome();
      outcome && subject_ && subject_->property == wanted.property) {
    picture_ = std::move(*outcome);
    ++revision_;
  }
  if (subject_ == wanted) return;
  if (job_.busy()) return job_.stop();
  subject_ = wanted;
  job_.start([scene = scene.shared(), view = previewer.viewpoint().view(), wanted](
                 const std::stop_token& stop, const auto& tell) {
    for (const SurfaceSampling& pass : passes) {
      const bool coarse = pass.step > 1;  // always finished
      SurfacePicture made = surface_picture(*scene, view, wanted.faces, wanted.property, pass,
                                            coarse ? std::stop_token() : stop);
      if (stop.stop_requested() && !coarse) return;
      tell(std::make_shared<const SurfacePicture>(std::move(made)));
    }
  });
}

SurfaceNames surface_names(const Previewer& previewer, glm::ivec2 pixel) {
  if (!previewer.scene() || !previewer.viewpoint().sized()) return {};
  const Hit hit = previewer.viewpoint().seen_at(pixel.x + 0.5, pixel.y + 0.5);
  if (!hit.valid()) return {};
  const World& world = previewer.scene()->world();
  const std::uint32_t part = world.triangle_part[hit.triangle];
  const std::uint32_t material = world.parts[part].material;
  return {name_or_number(world.parts[part].name, "Object", part),
          name_or_number(world.materials[material].name, "Material", material)};
}

}  // namespace asos::ui
