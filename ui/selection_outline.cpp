#include "ui/selection_outline.h"

#include "ui/previewer.h"

#include <algorithm>
#include <utility>

namespace asos::ui {

namespace {

// 1 where one of the parts is the nearest surface at the centre of a pixel. Empty once stopped.
std::vector<std::uint8_t> mask_of(const RenderScene& scene, const View& view, Culling faces,
                                  const std::vector<int>& parts, const std::stop_token& stop) {
  const World& world = scene.world();
  const auto width = static_cast<std::size_t>(view.width());
  std::vector<std::uint8_t> mask;
  std::vector<glm::dvec2> places(width);
  std::vector<Ray> rays(width);
  std::vector<Hit> hits(width);
  for (int y = 0; y < view.height(); ++y) {
    if (stop.stop_requested()) return {};
    for (std::size_t x = 0; x < width; ++x) places[x] = {static_cast<double>(x) + 0.5, y + 0.5};
    view.rays(places, rays);
    scene.rays().closest(rays, hits, faces);
    for (const Hit& hit : hits)
      mask.push_back(hit.valid() &&
                     std::binary_search(parts.begin(), parts.end(),
                                        static_cast<int>(world.triangle_part[hit.triangle])));
  }
  return mask;
}

}  // namespace

std::vector<PixelRun> border_of(const std::vector<std::uint8_t>& mask, int width) {
  std::vector<PixelRun> runs;
  const int height = static_cast<int>(mask.size()) / std::max(1, width);
  const auto at = [&](int x, int y) {
    return mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t own = at(x, y);
      const bool differs =
          (x > 0 && at(x - 1, y) != own) || (x + 1 < width && at(x + 1, y) != own) ||
          (y > 0 && at(x, y - 1) != own) || (y + 1 < height && at(x, y + 1) != own);
      if (differs) add_pixel(runs, x, y);
    }
  }
  return runs;
}

void SelectionOutline::update(const Previewer& previewer, std::vector<int> parts) {
  const OpenScene& scene = previewer.scene();
  if (parts.empty() || !scene || !previewer.viewpoint().sized() || previewer.playback().playing()) {
    job_.stop();
    subject_.reset();
    runs_.clear();
    return;
  }
  const RenderSettings& settings = previewer.edits().settings();
  Subject wanted{scene->geometry,
                 previewer.viewpoint().camera().revision(),
                 {settings.width, settings.height},
                 std::move(parts)};
  auto outcome = job_.take_outcome();
  if (subject_ == wanted) {
    if (outcome) runs_ = std::move(*outcome);
    return;
  }
  runs_.clear();
  if (job_.busy()) return job_.stop();
  subject_ = wanted;
  job_.start([shared = scene.shared(), view = previewer.viewpoint().view(),
              faces = culling_of(settings),
              wanted = std::move(wanted)](const std::stop_token& stop, const auto& tell) {
    tell(border_of(mask_of(*shared, view, faces, wanted.parts, stop), wanted.size.x));
  });
}

}  // namespace asos::ui
