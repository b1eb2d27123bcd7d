#include "app/render_report.h"

#include "app/printed_json.h"
#include "app/scene_info.h"
#include "renderer/lights/light_kinds.h"
#include "renderer/picture/picture_text.h"
#include "renderer/picture/settings_json.h"
#include "renderer/settings/names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace asos {
namespace {

nlohmann::ordered_json light_counts_json(const RenderReport& report) {
  nlohmann::ordered_json lights = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.lights.size(); ++i) {
    const LightStatistics counts = report.statistics.of_light(i);
    lights.push_back({{"name", report.lights[i].name},
                      {"type", name_in(light_type_names, report.lights[i].type)},
                      {"shadow_rays", counts.shadow_rays},
                      {"shadow_pyrays", counts.shadow_pyrays}});
  }
  return lights;
}

nlohmann::ordered_json edges_json(const std::optional<FeatureCounts>& edges) {
  if (!edges) return nullptr;
  return {{"open", edges->open},
          {"silhouette_candidates", edges->silhouette_candidates},
          {"crease", edges->crease},
          {"seam", edges->seam},
          {"intersection", edges->intersection},
          {"cut_out", edges->cut_out}};
}

// The times for loading and rendering the scene.
nlohmann::ordered_json measured_json(const RenderReport& report) {
  nlohmann::ordered_json measured{
      {"triangles", report.triangles},
      {"warnings", report.warnings},
      {"warning_count", report.warning_count},
      {"feature_edges", edges_json(report.feature_edges)},
      {"threads", report.threads},
      {"load_seconds", report.load_seconds},
      {"build_seconds", report.build_seconds},
      {"render_seconds", report.render_seconds},
      {"memory_mb", report.memory_mb},
      {"lights", light_counts_json(report)},
      {"left_out", left_out_json(report.render_features)},
  };
  if (report.time_limit_seconds) {
    measured["time_limit"] = {{"seconds", *report.time_limit_seconds},
                              {"finished", !report.stopped_at}};
    if (report.stopped_at) measured["time_limit"]["reached"] = reached_text(*report.stopped_at);
    if (report.interrupted) measured["time_limit"]["interrupted"] = true;
  }
  measured.update(counts_json(report.statistics));
  return measured;
}

}  // namespace

std::string reached_text(const Reached& reached) {
  const auto pass = [&]() -> std::string {
    switch (reached.pass) {
      case Reached::Pass::nothing:
        return "not all of it";
      case Reached::Pass::blocks:
        return "one sample for 8x8 pixels";
      case Reached::Pass::quarters:
        return "one sample for 4x4 pixels";
      case Reached::Pass::samples:
        return reached.samples == 1 ? "one sample a pixel"
                                    : fmt::format("{} samples a pixel", reached.samples);
      case Reached::Pass::final_pixels:
        break;
    }
    return "final";
  };
  // Rounds down: 100 % means finished.
  return fmt::format("{} everywhere, {} % final", pass(),
                     static_cast<int>(100.0 * reached.final_share));
}

nlohmann::ordered_json statistics_json(const RenderReport& report) {
  const PictureDescription& picture = report.description;
  nlohmann::ordered_json statistics{{"scene", report.scene},
                                    {"camera", picture.camera.name},
                                    {"exposure", picture.display.exposure_ev},
                                    {"needs", name_in(needs_names, picture.render_features)}};
  statistics.update(settings_json(picture.settings));
  statistics.update(measured_json(report));
  return statistics;
}

std::string statistics_text(const RenderReport& report) {
  return json_text(statistics_json(report));
}

ImageText picture_metadata(const RenderReport& report) {
  return picture_text(report.description, measured_json(report));
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
}

}  // namespace asos
