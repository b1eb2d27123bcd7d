#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <string>

namespace asos {

namespace {

std::string per_pixel(std::uint64_t count, double pixels) {
  return fmt::format("{:.2f} a pixel", static_cast<double>(count) / pixels);
}

std::string share(double part, double whole) {
  return fmt::format("{:.2f} %", 100.0 * part / whole);
}

}  // namespace

void statistics_panel(Controls& controls, const RenderStatistics& statistics,
                      const RenderSettings& settings) {
  if (!controls.section("Statistics")) return;
  const double pixels = static_cast<double>(settings.width) * static_cast<double>(settings.height);
  controls.row("Picture", fmt::format("{} x {}", settings.width, settings.height));
  controls.row("Eye rays", per_pixel(statistics.eye_rays, pixels));
  controls.row("Shadow rays", per_pixel(statistics.shadow_rays, pixels));
  if (settings.method == Method::asos) {
    controls.row("Split pixels", share(static_cast<double>(statistics.split_pixels), pixels),
                 "Pixels that a boundary passes through.");
    controls.row("Unresolved", share(statistics.unresolved_area, pixels),
                 "Area of the cells that were still undecided at MAX: it bounds the error.");
    controls.row("Saturated", share(static_cast<double>(statistics.saturated_pixels), pixels),
                 "Pixels with so many boundaries that they were sampled at the finest level at "
                 "once.");
    controls.row("Missed splits", fmt::format("{}", statistics.missed_splits),
                 "Pixels whose neighbours show another surface although no boundary was found "
                 "between them. Zero on sound meshes.");
  }
  if (statistics.rejected_samples > 0) {
    controls.row("Rejected", fmt::format("{} samples", statistics.rejected_samples),
                 "Samples that were not finite numbers and were dropped.");
  }
}

}  // namespace asos
