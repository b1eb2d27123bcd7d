#include "renderer/picture/picture_text.h"

#include "renderer/film/sample_path.h"
#include "renderer/film/split_cause.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace asos {

using Json = nlohmann::ordered_json;

Json counts_json(const RenderStatistics& counts) {
  Json causes = Json::object();
  for (std::size_t i = 1; i < split_cause_count; ++i)
    causes[split_cause_names[i]] = counts.pixels_by_cause[i];
  Json paths = Json::object();
  for (std::size_t i = 0; i < sample_path_count; ++i)
    paths[sample_path_names[i]] = counts.samples_by_path[i];
  return {{"rays",
           {{"eye", counts.eye_rays},
            {"shadow", counts.shadow_rays},
            {"reflection", counts.reflection_rays},
            {"sky", counts.sky_rays}}},
          {"samples_by_path", std::move(paths)},
          {"shadow_pyrays", counts.shadow_pyrays},
          {"pyrays_by_level", counts.pyrays_by_level},
          {"split_pixels", counts.split_pixels},
          {"pixels_by_cause", std::move(causes)},
          {"uneven_pixels", counts.uneven_pixels},
          {"saturated_pixels", counts.saturated_pixels},
          {"missed_splits", counts.missed_splits},
          {"unresolved_area", counts.unresolved_area},
          {"rejected_samples", counts.rejected_samples},
          {"cut_stacks", counts.cut_stacks}};
}

ImageText picture_text(const PictureDescription& description) {
  return {{"Software", "asos " ASOS_VERSION},
          {PictureDescription::key, description_text(description)}};
}

ImageText picture_text(const PictureDescription& description, const Json& statistics) {
  ImageText text = picture_text(description);
  text.emplace_back("asos.statistics",
                    statistics.dump(-1, ' ', false, Json::error_handler_t::replace));
  return text;
}

}  // namespace asos
