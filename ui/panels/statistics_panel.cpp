#include "renderer/comparison/method.h"
#include "renderer/settings/names.h"
#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asos {

namespace {

/// Shares and averages of the finished pixels; a dash before there are any.
struct Finished {
  double pixels;

  [[nodiscard]] std::string per_pixel(std::uint64_t count) const {
    return pixels > 0.0 ? fmt::format("{:.2f} a pixel", static_cast<double>(count) / pixels) : "-";
  }
  [[nodiscard]] std::string share(double part) const {
    return pixels > 0.0 ? fmt::format("{:.2f} %", 100.0 * part / pixels) : "-";
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
                 "Rays to this light, on average for each finished pixel, and its name.");
  }
  if (shown < lights.size()) {
    controls.row("   ...", fmt::format("and {} more", lights.size() - shown),
                 "Lights that are not listed here. The statistics that the command line writes "
                 "have them all.");
  }
}

// Rows stand or fall with the scene, not with the first ray: a panel that jumps is hard to use.
void ray_rows(Controls& controls, const RenderStatistics& statistics, const RenderScene& scene,
              const Finished& finished) {
  controls.row("Eye rays", finished.per_pixel(statistics.eye_rays),
               "Rays from the eye, on average for each finished pixel.");
  const std::vector<Light>& lights = scene.lights();
  if (scene.needs.shadows) {
    controls.row("Shadow rays", finished.per_pixel(statistics.shadow_rays),
                 "Rays to the lights, on average for each finished pixel.");
    light_rows(controls, statistics, lights, finished);
  }
  if (statistics.reflection_rays > 0) {
    controls.row("Reflection rays", finished.per_pixel(statistics.reflection_rays),
                 "Mirrored rays, on average for each finished pixel.");
  }
}

// A shadow's or a mirrored boundary has a cause, too, where it splits no pixel: of these there are
// more than of split pixels.
void cause_rows(Controls& controls, const RenderStatistics& statistics, const Finished& finished) {
  double in_map = 0.0;
  for (std::size_t i = 1; i < split_cause_count; ++i)
    in_map += static_cast<double>(statistics.pixels_by_cause[i]);
  controls.row("In the split map", finished.share(in_map),
               "Pixels that the split map shows by cause: those that are split, those that a "
               "shadow's edge cuts, and those that mirror a boundary.");
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    if (statistics.pixels_by_cause[i] == 0) continue;
    std::string name = split_cause_names[i];
    std::replace(name.begin(), name.end(), '_', ' ');
    controls.row(("   " + name).c_str(),
                 finished.share(static_cast<double>(statistics.pixels_by_cause[i])),
                 "Pixels that are split for this above all, as a share of the finished ones. Hard "
                 "shadows also count where they cut a pixel that is not split otherwise.");
  }
}

void split_rows(Controls& controls, const RenderStatistics& statistics, const Finished& finished) {
  controls.row("Split pixels", finished.share(static_cast<double>(statistics.split_pixels)),
               "Pixels that a boundary passes through, as a share of the finished ones.");
  cause_rows(controls, statistics, finished);
  controls.row("Missed splits", fmt::format("{}", statistics.missed_splits),
               "Number of pixels whose neighbours show another surface although no boundary was "
               "found between them. Zero on sound meshes.");
  controls.row("Unresolved area", finished.share(statistics.unresolved_area),
               "Area of the cells that were still undecided at MAX, as a share of the finished "
               "pixels: it bounds the error.");
  controls.row("Uneven", finished.share(static_cast<double>(statistics.uneven_pixels)),
               "Pixels of which parts were split for their shading alone.");
  controls.row("Saturated", finished.share(static_cast<double>(statistics.saturated_pixels)),
               "Share of the pixels with so many boundaries that they were sampled at the finest "
               "level at once.");
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
  if (statistics.rejected_samples > 0) {
    controls.row("Rejected", fmt::format("{} samples", statistics.rejected_samples),
                 "Samples that were not finite numbers and were dropped.");
  }
}

}  // namespace asos
