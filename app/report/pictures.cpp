#include "app/report/pictures.h"

#include "renderer/film/split_map.h"
#include "renderer/study/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace asos {
namespace fs = std::filesystem;
namespace {

std::string path_in(const std::string& folder, const std::string& name, const std::string& what) {
  return figure_path(folder, name, what + ".png");
}

Result<void> write_errors(const std::string& path, const Film& film, const Film& reference,
                          double scale) {
  return write_map(path, film.width, film.height, [&](std::size_t i) {
    const double error = std::sqrt(squared_error(film.radiance[i], reference.radiance[i], true));
    return error_colour(error / scale);
  });
}

Result<void> write_scene_maps(const SceneReport& scene, const std::string& folder,
                              const std::string& name, ScenePictures& made) {
  const RegionMap& map = scene.regions;
  made.levels = path_in(folder, name, "split-levels");
  made.causes = path_in(folder, name, "split-causes");
  made.regions = path_in(folder, name, "regions");
  const auto write = [&](const std::string& path, auto colour_of) {
    return write_map(path, map.width, map.height, colour_of);
  };
  return write(made.levels, [&](std::size_t i) { return SplitMapKey{}.colour(map.split_value[i]); })
      .and_then([&] {
        return write(made.causes, [&](std::size_t i) { return split_cause_colour(map.cause[i]); });
      })
      .and_then([&] {
        return write(made.regions, [&](std::size_t i) { return region_colour(map.region[i]); });
      });
}

}  // namespace

glm::u8vec3 error_colour(double share) {
  // Five colours of matplotlib's inferno (van der Walt and Smith 2015), interpolated linearly.
  constexpr std::array<std::array<double, 3>, 5> steps{
      {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}}};
  const double at = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) * 4.0 : 4.0;
  const std::size_t i = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  const double t = at - static_cast<double>(i);
  glm::u8vec3 colour;
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<std::size_t>(c);
    colour[c] =
        static_cast<std::uint8_t>(std::lround((1.0 - t) * steps[i][k] + t * steps[i + 1][k]));
  }
  return colour;
}

glm::u8vec3 region_colour(Region region) {
  // Colours of Okabe and Ito's palette, as for the causes of splits.
  switch (region) {
    case Region::outlines:
      return {240, 228, 66};
    case Region::penumbrae:
      return {204, 121, 167};
    case Region::reflections:
      return {86, 180, 233};
    case Region::textures:
      return {0, 158, 115};
    case Region::rest:
      break;
  }
  return {60, 60, 60};
}

bool is_anchor(const LadderStep& step) {
  const AsosSettings usual;
  return step.method == "asos" && step.settings.asos.max_level == usual.max_level &&
         step.settings.asos.eps == usual.eps;
}

std::string figure_path(const std::string& folder, const std::string& name,
                        const std::string& what) {
  return (fs::path(folder) / fmt::format("{}-{}", name, what)).string();
}

Result<ScenePictures> write_pictures(const SceneReport& scene, const std::string& folder,
                                     const std::string& name) {
  ScenePictures made;
  made.shown.push_back({"reference", path_in(folder, name, "reference"), "", nullptr});
  if (const auto written = write_png(made.shown[0].picture, scene.reference, 0.0f, {}); !written)
    return tl::unexpected(written.error());

  // All maps have the same scale, so that they can be compared; few pixels exceed it.
  const std::vector<const StudyPoint*> points = alike_in_time(scene.study.points);
  for (const StudyPoint* p : points)
    made.error_scale = std::max(made.error_scale, p->measures.p999);
  if (!(made.error_scale > 0.0)) made.error_scale = 1.0;
  for (const StudyPoint* p : points) {
    const auto place = static_cast<std::size_t>(p - scene.study.points.data());
    const auto image = read_exr(scene.pictures[place]);
    if (!image) return tl::unexpected(image.error());
    ShownPicture shown{fmt::format("{} {}", p->rung.method, p->rung.setting),
                       path_in(folder, name, p->rung.method),
                       path_in(folder, name, p->rung.method + "-errors"), p};
    const auto written = write_png(shown.picture, image->film, 0.0f, {}).and_then([&] {
      return write_errors(shown.errors, image->film, scene.reference, made.error_scale);
    });
    if (!written) return tl::unexpected(written.error());
    made.shown.push_back(std::move(shown));
  }
  if (const auto written = write_scene_maps(scene, folder, name, made); !written)
    return tl::unexpected(written.error());
  return made;
}

}  // namespace asos
