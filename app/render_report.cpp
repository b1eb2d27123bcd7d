#include "app/render_report.h"

#include "app/scene_info.h"
#include "renderer/methods/names.h"
#include "renderer/shading/sky.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace asos {
namespace {

nlohmann::ordered_json causes_json(const RenderStatistics& counts) {
  nlohmann::ordered_json causes = nlohmann::ordered_json::object();
  for (std::size_t i = 1; i < split_cause_count; ++i)
    causes[split_cause_names[i]] = counts.pixels_by_cause[i];
  return causes;
}

nlohmann::ordered_json lights_json(const RenderReport& report) {
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

}  // namespace

nlohmann::ordered_json statistics_json(const RenderReport& report) {
  const RenderSettings& settings = report.settings;
  const RenderStatistics& counts = report.statistics;
  const FeatureCounts& edges = report.feature_edges;
  return {
      {"scene", report.scene},
      {"triangles", report.triangles},
      {"feature_edges",
       {{"open", edges.open},
        {"silhouette_candidates", edges.silhouette_candidates},
        {"crease", edges.crease},
        {"seam", edges.seam},
        {"intersection", edges.intersection}}},
      {"width", settings.width},
      {"height", settings.height},
      {"crop", settings.crop.empty()
                   ? nlohmann::ordered_json(nullptr)
                   : nlohmann::ordered_json{settings.crop.x, settings.crop.y, settings.crop.width,
                                            settings.crop.height}},
      {"camera", report.camera},
      {"exposure", report.exposure_ev},
      {"method", name_in(method_names, settings.method)},
      {"max_level", settings.max_level},
      {"eps", settings.eps},
      {"leaf", name_in(leaf_names, settings.leaf)},
      {"rule", name_in(rule_names, settings.rule)},
      {"detect", name_in(detection_names, settings.detect)},
      {"fat", settings.fat},
      {"texture_filter", name_in(texture_filter_names, settings.texture_filter)},
      {"texture_resolution", settings.texture_resolution},
      {"sky", settings.sky ? settings.sky->name() : "neutral"},
      {"refine_shading", settings.refine_shading},
      {"cull", settings.cull},
      {"shadows", settings.shadows},
      {"shadow_quality", name_in(shadow_quality_names, settings.shadow_quality)},
      {"shadow_divisions", settings.shadow_divisions},
      {"light_rule", name_in(light_rule_names, settings.light_rule)},
      {"reflections", settings.reflections},
      {"roughest_mirror", settings.roughest_mirror},
      {"curved_mirror", name_in(curved_mirror_names, settings.curved_mirror)},
      {"mirror_angle", settings.mirror_angle},
      {"jitter", settings.jitter},
      {"spp", settings.spp},
      {"contrast", settings.contrast},
      {"depth", settings.depth},
      {"spheres", settings.spheres},
      {"contrast_scale", settings.contrast_scale},
      {"seed", settings.seed},
      {"threads", report.threads},
      {"load_seconds", report.load_seconds},
      {"build_seconds", report.build_seconds},
      {"render_seconds", report.render_seconds},
      {"memory_mb", report.memory_mb},
      {"rays",
       {{"eye", counts.eye_rays},
        {"shadow", counts.shadow_rays},
        {"reflection", counts.reflection_rays}}},
      {"shadow_pyrays", counts.shadow_pyrays},
      {"lights", lights_json(report)},
      {"pyrays_by_level", counts.pyrays_by_level},
      {"split_pixels", counts.split_pixels},
      {"pixels_by_cause", causes_json(counts)},
      {"uneven_pixels", counts.uneven_pixels},
      {"saturated_pixels", counts.saturated_pixels},
      {"missed_splits", counts.missed_splits},
      {"unresolved_area", counts.unresolved_area},
      {"rejected_samples", counts.rejected_samples},
      {"needs", name_in(needs_names, report.needs_choice)},
      {"left_out", left_out_json(report.needs)},
  };
}

std::string statistics_text(const RenderReport& report) {
  return statistics_json(report).dump(2, ' ', false,
                                      nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

ImageText picture_metadata(const RenderReport& report) {
  ImageText metadata{{"Software", "asos " ASOS_VERSION}};
  const nlohmann::ordered_json statistics = statistics_json(report);
  for (const auto& [key, value] : statistics.items()) {
    // Scenes' paths are bytes to us and may be no UTF-8; dump() has to survive that.
    const std::string text =
        value.is_string()
            ? value.get<std::string>()
            : value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    metadata.emplace_back("asos." + key, text);
  }
  return metadata;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
}

}  // namespace asos
