#include "renderer/comparison/method.h"
#include "renderer/files/counted.h"
#include "renderer/lights/light_kinds.h"
#include "ui/panels/overlays.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

/// Fractions and averages over the finished pixels; a dash before there are any.
struct Finished {
  double pixels;

  [[nodiscard]] std::string per_pixel(std::uint64_t count) const {
    return pixels > 0.0 ? fmt::format("{:.2f} per pixel", static_cast<double>(count) / pixels)
                        : "-";
  }
  [[nodiscard]] std::string share(double part) const {
    return pixels > 0.0 ? fmt::format("{:.2f} %", 100.0 * part / pixels) : "-";
  }
  [[nodiscard]] std::string number(std::uint64_t count, const char* thing) const {
    return pixels > 0.0 ? counted(count, thing) : "-";
  }
};

constexpr std::size_t most_light_rows = 8;

void light_rows(Controls& controls, const RenderStatistics& statistics,
                const std::vector<Light>& lights, const Finished& finished) {
  const std::size_t shown = std::min(lights.size(), most_light_rows);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string rays = finished.per_pixel(statistics.of_light(i).shadow_rays);
    controls.row(fmt::format("   {} {}", i + 1, name_in(light_type_names, lights[i].type)).c_str(),
                 lights[i].name.empty() ? rays : rays + ", " + lights[i].name,
                 "Rays to this light per finished pixel.");
  }
  if (shown < lights.size()) {
    controls.row("   ...", fmt::format("and {} more", lights.size() - shown),
                 "More lights; command-line statistics list all.");
  }
}

// Rows depend on scene and settings, not on whether something was counted yet, so that the panel
// does not jump.
void ray_rows(Controls& controls, const RenderStatistics& statistics, const RenderScene& scene,
              const Finished& finished) {
  controls.row("Eye rays", finished.per_pixel(statistics.eye_rays),
               "Camera rays per finished pixel.");
  const std::vector<Light>& lights = scene.lights();
  if (scene.render_features.shadows) {
    controls.row("Shadow rays", finished.per_pixel(statistics.shadow_rays),
                 "Shadow rays per finished pixel.");
    light_rows(controls, statistics, lights, finished);
  }
  controls.row("Reflection rays", finished.per_pixel(statistics.reflection_rays),
               "Reflected rays per finished pixel.");
}

void cause_rows(Controls& controls, const RenderStatistics& statistics, const Finished& finished) {
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    controls.row((std::string("   ") + split_cause_titles[i]).c_str(),
                 finished.share(static_cast<double>(statistics.pixels_by_cause[i])),
                 "Percentage of pixels split for this cause.");
  }
}

void split_rows(Controls& controls, const RenderStatistics& statistics, const Finished& finished) {
  controls.row("Split pixels", finished.share(static_cast<double>(statistics.split_pixels)),
               "Percentage of pixels that are exact or of level 1 and deeper.");
  cause_rows(controls, statistics, finished);
  controls.row("Edges not found", finished.number(statistics.missed_splits, "pixel"),
               "Pixels whose neighbours show another surface, without an edge between. Zero on "
               "sound meshes.");
  controls.row("Unresolved area", finished.share(statistics.unresolved_area),
               "Area of cells unresolved at MAX. It bounds the error.");
  controls.row("Split for shading", finished.share(static_cast<double>(statistics.uneven_pixels)),
               "Pixels with parts split for shading alone.");
  controls.row("Too many edges", finished.share(static_cast<double>(statistics.saturated_pixels)),
               "Percentage of pixels sampled for too many edges.");
}

}  // namespace

void statistics_panel(Controls& controls, const RenderStatistics& statistics,
                      const RenderSettings& settings, const RenderScene& scene,
                      double finished_share) {
  if (!controls.section("Statistics")) return;
  const Finished finished{finished_share * static_cast<double>(settings.width) *
                          static_cast<double>(settings.height)};
  controls.row("Picture", fmt::format("{} x {}", settings.width, settings.height),
               "Width and height in pixels.");
  ray_rows(controls, statistics, scene, finished);
  if (in_object_space(settings.method)) split_rows(controls, statistics, finished);
  controls.row("Rejected", finished.number(statistics.rejected_samples, "sample"),
               "Samples dropped for not being finite numbers.");
  controls.row("Cut stacks", finished.number(statistics.cut_stacks, "ray"),
               "Rays that passed 1,024 surfaces and went no farther.");
}

}  // namespace asos::ui
