#include "ui/screenshot.h"

#include "renderer/methods/names.h"
#include "ui/display_settings.h"
#include "ui/previewer.h"

#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace asos {

std::filesystem::path screenshot_folder() {
  std::error_code ignored;
  const char* pictures = std::getenv("XDG_PICTURES_DIR");
  if (pictures && std::filesystem::is_directory(pictures, ignored)) return pictures;
  const std::filesystem::path here = std::filesystem::current_path(ignored);
  return here.empty() ? std::filesystem::path(".") : here;
}

std::string screenshot_stem(const std::string& source) {
  std::string stem = source.starts_with("builtin:") ? source.substr(8)
                                                    : std::filesystem::path(source).stem().string();
  for (char& c : stem) {
    if (c == '/' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return stem.empty() ? "picture" : stem;
}

namespace {

// As the command line takes it, in the author's coordinates.
std::string look_at_words(const OrbitCamera& orbit, glm::dvec3 origin) {
  const Camera camera = orbit.camera();
  const glm::dvec3 eye = glm::dvec3(camera.world_from_camera[3]) + origin;
  const glm::dvec3 target = orbit.pivot() + origin;
  std::string words = fmt::format("--look-at {:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}", eye.x,
                                  eye.y, eye.z, target.x, target.y, target.z);
  return camera.type == Camera::Type::perspective
             ? words + fmt::format(" --fov {:.9g}", glm::degrees(camera.fov_y_rad))
             : words + fmt::format(" (orthographic, height {:.9g})", camera.height);
}

void add_method(ImageText& text, const RenderSettings& settings) {
  text.emplace_back("asos.method", name_in(method_names, settings.method));
  text.emplace_back("asos.texture_filter", name_in(texture_filter_names, settings.texture_filter));
  text.emplace_back("asos.shadows", settings.shadows ? "true" : "false");
  switch (settings.method) {
    case Method::asos:
    case Method::asos_published: {
      const RenderSettings used = as_published(settings);
      text.emplace_back("asos.max_level", std::to_string(used.max_level));
      text.emplace_back("asos.eps", fmt::format("{}", used.eps));
      text.emplace_back("asos.leaf", name_in(leaf_names, used.leaf));
      text.emplace_back("asos.rule", name_in(rule_names, used.rule));
      text.emplace_back("asos.detect", name_in(detection_names, used.detect));
      text.emplace_back("asos.fat", std::to_string(used.fat));
      text.emplace_back("asos.refine_shading", used.refine_shading ? "true" : "false");
      text.emplace_back("asos.jitter", used.jitter ? "true" : "false");
      text.emplace_back("asos.shadow_quality", name_in(shadow_quality_names, used.shadow_quality));
      text.emplace_back("asos.shadow_divisions", std::to_string(used.shadow_divisions));
      text.emplace_back("asos.light_rule", name_in(light_rule_names, used.light_rule));
      break;
    }
    case Method::whitted:
      text.emplace_back("asos.contrast", fmt::format("{}", settings.contrast));
      text.emplace_back("asos.depth", std::to_string(settings.depth));
      text.emplace_back("asos.spheres", settings.spheres ? "true" : "false");
      text.emplace_back("asos.seed", std::to_string(settings.seed));
      break;
    case Method::mitchell:
      text.emplace_back("asos.contrast_scale", fmt::format("{}", settings.contrast_scale));
      text.emplace_back("asos.seed", std::to_string(settings.seed));
      text.emplace_back("asos.spp", std::to_string(settings.spp));
      break;
    case Method::sobol:
      text.emplace_back("asos.seed", std::to_string(settings.seed));
      text.emplace_back("asos.spp", std::to_string(settings.spp));
      break;
    case Method::uniform:
    case Method::stochastic:
    case Method::ray_bound:
      text.emplace_back("asos.spp", std::to_string(settings.spp));
      break;
    case Method::average:
      text.emplace_back("asos.seed", std::to_string(settings.seed));
      break;
    case Method::beam:
      break;
  }
}

}  // namespace

ImageText screenshot_text(const Previewer& previewer, const DisplaySettings& display) {
  ImageText text{{"Software", "asos"}};
  const RenderScene* scene = previewer.scene();
  if (!scene) return text;
  const RenderSettings& settings = previewer.rendered_settings();
  const RenderStatistics statistics = previewer.statistics();
  const Progress progress = previewer.progress();
  const auto add = [&text](std::string key, std::string value) {
    text.emplace_back(std::move(key), std::move(value));
  };
  add("asos.scene", scene->source);
  add("asos.triangles", std::to_string(scene->world.triangles.size()));
  add("asos.camera", look_at_words(previewer.camera(), scene->world.origin));
  add("asos.width", std::to_string(settings.width));
  add("asos.height", std::to_string(settings.height));
  add("asos.exposure", fmt::format("{}", display.exposure_ev));
  add("asos.split_map", display.show_split_map ? "true" : "false");
  if (display.show_split_map)
    add("asos.split_map_colours", name_in(split_map_names, display.split_colours));
  add_method(text, settings);
  add("asos.render_seconds", fmt::format("{:.3f}", progress.seconds));
  add("asos.finished_percent", fmt::format("{:.1f}", 100.0 * progress.fraction));
  add("asos.rays", fmt::format("eye {}, shadow {}, reflection {}", statistics.eye_rays,
                               statistics.shadow_rays, statistics.reflection_rays));
  add("asos.split_pixels", std::to_string(statistics.split_pixels));
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    const std::uint64_t pixels = statistics.pixels_by_cause[i];
    if (pixels > 0)
      add("asos.pixels_by_cause." + std::string(split_cause_names[i]), std::to_string(pixels));
  }
  add("asos.missed_splits", std::to_string(statistics.missed_splits));
  add("asos.unresolved_area", fmt::format("{:.3f}", statistics.unresolved_area));
  return text;
}

Result<std::string> save_screenshot(const RgbImage& image, const std::filesystem::path& folder,
                                    const std::string& stem) {
  constexpr int most = 9999;
  for (int number = 1; number <= most; ++number) {
    const std::filesystem::path path = folder / fmt::format("{}-{:03}.png", stem, number);
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) continue;
    if (const Result<void> written = write_png(path.string(), image); !written) {
      return unexpected(written.error());
    }
    return path.string();
  }
  return unexpected(Error{folder.string(), fmt::format("holds {} screenshots of {}", most, stem)});
}

}  // namespace asos
